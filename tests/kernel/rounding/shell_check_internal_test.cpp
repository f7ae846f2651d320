#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "mesh/coincident_points.h"
#include "mesh/measure.h"
#include "rounding/shell_check.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

mesh::ExactMesh exact(const TriMesh& mesh) {
  mesh::ExactMesh result;
  result.points = mesh.points;
  result.triangles = mesh.triangles;
  return result;
}

TEST(ShellOfPoints, is_its_lowest_one) {
  TriMesh mesh = test::joined({test::tetrahedron(), test::box({5, 5, 5}, {6, 6, 6})});
  mesh.points.emplace_back(9, 9, 9);  // of no triangle
  const auto shell_of = shell_of_points(exact(mesh));
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    EXPECT_EQ(shell_of[v], v < 4 ? 0 : v < 12 ? 4 : 12);
  }
}

TEST(TurnedShells, are_those_whose_volume_changes_its_sign) {
  std::mt19937 random(1);
  std::size_t turned = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<TriMesh> shells;
    for (int i = 0; i < 5; ++i) {
      shells.push_back(test::tetrahedron(Vec3(10 * i, 0, 0), i % 2 == 0 ? 0.5 : 3));
    }
    const TriMesh before = test::joined(shells);
    TriMesh after = before;
    std::uniform_real_distribution<double> offset(-0.4, 0.4);
    double largest = 0;
    for (std::size_t v = 0; v < after.points.size(); ++v) {
      const Vec3 move(offset(random), offset(random), offset(random));
      after.points[v] += move;
      largest = std::max(largest, move.norm());
    }
    const auto given = exact(before);
    auto faces = turned_shells(mesh::MeshView(given), shell_of_points(given),
                               {after.points, after.triangles}, largest * 1.001);
    std::ranges::transform(faces, faces.begin(), [](std::uint32_t f) { return f / 4; });
    std::ranges::sort(faces);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 5; ++i) {
      const auto own = std::span(after.triangles).subspan(4 * std::size_t{i}, 4);
      if (mesh::volume_sign({after.points, own}) != 1) {
        expected.push_back(i);
      }
    }
    ASSERT_EQ(faces, expected) << round;
    turned += expected.size();
  }
  EXPECT_GT(turned, 20);
}

TEST(CrossedContacts, are_edges_where_sheets_pass_through_each_other) {
  // Two boxes that touch along an edge; then the second one's corner lies in the first.
  const TriMesh touching =
      test::joined({test::box({0, 0, 0}, {2, 2, 2}), test::box({2, 2, 0}, {4, 4, 2})});
  const auto representatives = mesh::coincident_representatives(touching.points);
  EXPECT_TRUE(crossed_contacts({touching.points, touching.triangles}, representatives).empty());
  TriMesh crossed = touching;
  for (std::size_t v = 8; v < 16; ++v) {
    Vec3& p = crossed.points[v];
    if (p.x() == 4 && p.y() == 2) {
      p.x() = 1;  // across the side x = 2 of the first box
    }
  }
  const auto faces = crossed_contacts({crossed.points, crossed.triangles}, representatives);
  EXPECT_EQ(faces.size(), 4);
  EXPECT_TRUE(std::ranges::any_of(faces, [](std::uint32_t f) { return f < 12; }));
  EXPECT_TRUE(std::ranges::any_of(faces, [](std::uint32_t f) { return f >= 12; }));
}

TEST(SmallShells, are_removed_within_the_reach) {
  const TriMesh mesh =
      test::joined({test::box({0, 0, 0}, {9, 9, 9}), test::tetrahedron({20, 0, 0}, 0.01),
                    test::tetrahedron({30, 0, 0}, 0.01)});
  std::vector<std::uint32_t> own(mesh.points.size());
  std::iota(own.begin(), own.end(), 0U);
  EditedMesh edited(mesh.points, mesh.triangles, {}, own);
  EXPECT_EQ(remove_small_shells(edited, {0, 12, 13}, 0.001), 0);
  EXPECT_EQ(remove_small_shells(edited, {0, 12, 13}, 0.1), 1) << "the box is large, one not named";
  for (std::uint32_t f = 0; f < edited.face_count(); ++f) {
    EXPECT_EQ(edited.alive(f), f < 12 || f >= 16);
  }
}

}  // namespace
}  // namespace dupin::rounding
