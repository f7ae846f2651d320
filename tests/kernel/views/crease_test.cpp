#include "dupin/kernel/crease.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using std::numbers::pi;

bool always(std::uint32_t, std::uint32_t) { return true; }

// A box whose sides up, down and around are labelled 0, 1 and 2.
TriMesh labelled_box() {
  TriMesh mesh = test::box({0, 0, 0}, {1, 2, 3});
  mesh.names = {"up", "down", "around"};
  for (const auto& [a, b, c] : mesh.triangles) {
    const double low = std::min({mesh.points[a][2], mesh.points[b][2], mesh.points[c][2]});
    const double high = std::max({mesh.points[a][2], mesh.points[b][2], mesh.points[c][2]});
    mesh.labels.push_back(low == 3 ? 0 : high == 0 ? 1 : 2);
  }
  return mesh;
}

TEST(Crease, are_the_edges_between_labels_that_divide) {
  const TriMesh mesh = labelled_box();
  const std::vector<Crease> all = creases_between_labels(mesh, 1e-3, always);
  EXPECT_EQ(all.size(), 8);
  for (const Crease& crease : all) {
    const Vec3& a = mesh.points[crease.points[0]];
    EXPECT_EQ(a[2], mesh.points[crease.points[1]][2]);
    EXPECT_NEAR(crease.outward[2], a[2] == 3 ? std::sqrt(.5) : -std::sqrt(.5), 1e-15);
    EXPECT_NE(mesh.labels[crease.triangles[0]], mesh.labels[crease.triangles[1]]);
  }
  EXPECT_EQ(creases_between_labels(mesh, 1e-3,
                                   [](auto low, auto high) {
                                     EXPECT_LT(low, high);
                                     return low == 0;
                                   })
                .size(),
            4);
}

TEST(Crease, turn_by_more_than_the_angle) {
  EXPECT_EQ(creases_between_labels(labelled_box(), pi / 2 - 1e-9, always).size(), 8);
  EXPECT_EQ(creases_between_labels(labelled_box(), pi / 2 + 1e-9, always).size(), 0);
}

TEST(Crease, are_none_of_a_mesh_without_labels) {
  EXPECT_TRUE(creases_between_labels(test::box({0, 0, 0}, {1, 1, 1}), 0, always).empty());
}

// Two boxes that touch along an edge, each with its own label: the edge counts once.
TEST(Crease, of_four_triangles_count_once) {
  TriMesh mesh = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  mesh.names = {"a", "b"};
  for (std::size_t i = 0; i < 24; ++i) {
    mesh.labels.push_back(i < 12 ? 0 : 1);
  }
  // One point for the corners (1, 1, 0) and (1, 1, 1) of both.
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      for (std::uint32_t i = 0; i < corner; ++i) {
        corner = mesh.points[i] == mesh.points[corner] ? i : corner;
      }
    }
  }
  EXPECT_EQ(creases_between_labels(mesh, 1e-3, always).size(), 1);
}

TEST(Crease, turn_by_more_than_a_number) {
  TriMesh box = test::labelled(test::box({0, 0, 0}, {1, 1, 1}), "box");
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  EXPECT_THROW((void)creases_between_labels(box, std::nan(""), all), Error);
  EXPECT_THROW((void)creases_between_labels(box, 1, {}), Error);
  box.triangles[0][0] = 8;
  EXPECT_THROW((void)creases_between_labels(box, 1, all), Error);
}

}  // namespace
}  // namespace dupin
