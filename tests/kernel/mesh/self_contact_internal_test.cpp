#include <array>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/coincident_points.h"
#include "mesh/self_contact.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

using testing::ElementsAre;

std::vector<ContactPlace> contacts_of(const TriMesh& mesh) {
  return find_contacts({mesh.points, mesh.triangles}, coincident_representatives(mesh.points));
}

TEST(SelfContact, faces_are_sorted_around_an_edge_counter_clockwise) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    // Fins at the edge from (0, 0, 0) to (1, 2, 2), each at an angle of its own.
    const Vec3 axis(1, 2, 2), u(2, 1, -2), w = axis.cross(u) / 3;
    std::vector<Vec3> points{Vec3::Zero(), axis};
    std::vector<Triangle> triangles;
    std::vector<double> angles;
    for (std::uint32_t i = 0; i < 3 + static_cast<std::uint32_t>(round) % 6; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(random() % 1000) / 1000;
      angles.push_back(angle);
      const double along = static_cast<double>(random() % 9) - 4;
      points.push_back(along * axis + std::cos(angle) * u + std::sin(angle) * w);
      triangles.push_back(random() % 2 == 0 ? Triangle{0, 1, i + 2} : Triangle{1, 0, i + 2});
    }
    const EdgeTable edges(triangles, points.size());
    ASSERT_EQ(edges[0].high, 1U);
    std::vector<std::uint32_t> expected(triangles.size());
    for (std::uint32_t i = 0; i < expected.size(); ++i) {
      expected[i] = 3 * i;
    }
    const auto from_first = [&](std::uint32_t half_edge) {
      const double turned = angles[half_edge / 3] - angles[0];
      return turned < 0 ? turned + 2 * M_PI : turned;
    };
    std::ranges::stable_sort(expected, {}, from_first);
    const bool has_equal = std::ranges::adjacent_find(expected, {}, from_first) != expected.end();
    if (!has_equal) {
      EXPECT_EQ(sorted_around({points, triangles}, edges, edges[0]), expected);
    }
  }
}

TEST(SelfContact, of_boxes_is_where_they_touch) {
  const TriMesh at_edge =
      test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  const std::vector<ContactPlace> edge = contacts_of(at_edge);
  ASSERT_EQ(edge.size(), 1U);
  EXPECT_EQ(edge[0].kind, Contact::Kind::edge);
  EXPECT_EQ(at_edge.points[edge[0].from], Vec3(1, 1, 0));
  EXPECT_EQ(at_edge.points[edge[0].to], Vec3(1, 1, 1));
  EXPECT_EQ(edge[0].faces.size(), 4U);
  EXPECT_TRUE(edge[0].alternating);

  const std::vector<ContactPlace> vertex =
      contacts_of(test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 1}, {2, 2, 2})}));
  ASSERT_EQ(vertex.size(), 1U);
  EXPECT_EQ(vertex[0].kind, Contact::Kind::vertex);
  EXPECT_EQ(vertex[0].from, vertex[0].to);
  EXPECT_THAT(contacts_of(test::frame()), testing::IsEmpty());
}

TEST(SelfContact, is_named_by_the_faces_of_the_whole_mesh) {
  const std::vector<TriMesh> alone = {
      test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})}),
      test::joined({test::box({5, 0, 0}, {6, 1, 1}), test::box({6, 1, 1}, {7, 2, 2})})};
  const TriMesh frame = test::frame();
  const TriMesh all = test::joined({frame, alone[0], frame, alone[1]});
  const std::vector<ContactPlace> edge = contacts_of(alone[0]), vertex = contacts_of(alone[1]);
  TriMesh apart = all;
  for (std::size_t v = 0; v < frame.points.size(); ++v) {
    apart.points[v].z() += 10;
    apart.points[frame.points.size() + alone[0].points.size() + v].z() += 20;
  }
  const std::vector<ContactPlace> places = contacts_of(apart);
  ASSERT_EQ(places.size(), 2U);
  const std::array<std::size_t, 2> first{frame.triangles.size(),
                                         2 * frame.triangles.size() + alone[0].triangles.size()};
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<std::uint32_t> expected = (i == 0 ? edge : vertex)[0].faces;
    for (std::uint32_t& face : expected) {
      face += static_cast<std::uint32_t>(first[i]);
    }
    EXPECT_EQ(places[i].faces, expected);
    EXPECT_TRUE(places[i].alternating);
  }
}

TEST(SelfContact, that_crosses_or_covers_does_not_alternate) {
  // The second box overlaps the first; both have the edge from (1, 0, 0) to (1, 0, 1).
  const std::vector<ContactPlace> places = contacts_of(test::joined(
      {test::box({0, 0, 0}, {1, 1, 1}), test::reversed(test::box({1, -1, 0}, {2, 0, 1}))}));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_FALSE(places[0].alternating);
}

TEST(SelfContact, is_taken_apart_by_a_point_for_every_fan) {
  // Two tetrahedra with a corner in common, as one point.
  const TriMesh both =
      test::joined({test::tetrahedron(), test::reversed(test::tetrahedron({0, 0, 0}, -1))});
  ExactMesh mesh;
  mesh.points = both.points;
  mesh.points.erase(mesh.points.begin() + 4);
  mesh.triangles = both.triangles;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = corner == 4 ? 0 : corner > 4 ? corner - 1 : corner;
    }
  }
  mesh.labels.assign(mesh.triangles.size(), 0);
  std::fill(mesh.labels.begin() + 4, mesh.labels.end(), 1U);
  mesh.names = {"left", "right"};
  const std::vector<Vec3> points = mesh.points;
  const std::vector<Triangle> triangles = mesh.triangles;
  separate_contacts(mesh);
  EXPECT_EQ(mesh.points.size(), 8U);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.points[mesh.triangles[f][k]], points[triangles[f][k]]);
    }
  }
  const EdgeTable edges(mesh.triangles, mesh.points.size());
  EXPECT_EQ(shells(mesh.triangles.size(), edges).count, 2U);
  ASSERT_EQ(mesh.contacts.size(), 1U);
  EXPECT_EQ(mesh.contacts[0].from, Vec3::Zero());
  EXPECT_THAT(mesh.contacts[0].names, ElementsAre("left", "right"));
}

}  // namespace
}  // namespace dupin::mesh
