#include <cmath>

#include <gtest/gtest.h>

#include "kernel/meshing/solver_mesh_checks.h"
#include "meshing/angle_improvement.h"
#include "meshing/delaunay_refinement.h"

namespace dupin::meshing {
namespace {

/// A pyramid over the square from 0 to 4 whose point in the base, which is cut about it, is `at`.
Tetrahedra pyramid(const Vec3& at) {
  Tetrahedra mesh;
  mesh.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, at, {2, 2, 5}};
  mesh.may_move = {0, 0, 0, 0, 1, 0};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t k = (i + 1) % 4;
    mesh.tetrahedra.push_back({4, i, k, 5});
    mesh.triangles.push_back({i, 4, k});
    mesh.regions.push_back(0);
    mesh.triangles.push_back({i, k, 5});
    mesh.regions.push_back(1 + i);
  }
  return mesh;
}

TEST(AngleImprovement, moves_a_point_within_its_region) {
  Tetrahedra mesh = pyramid(Vec3(0.5, 0.25, 0));
  const Tetrahedra before = mesh;
  const ReferenceSurface surface(before.points, before.triangles, before.regions);
  improve_angles(mesh, surface, 25 * test::kDegree);
  EXPECT_EQ(mesh.points[4].z(), 0);
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 2) {
    const auto& [a, b, c] = mesh.triangles[f];
    EXPECT_GE(smallest_angle(mesh.points[a], mesh.points[b], mesh.points[c]), 25 * test::kDegree);
  }
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    EXPECT_TRUE(is_positive(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]));
  }
}

TEST(AngleImprovement, leaves_points_that_may_not_move_and_good_ones) {
  Tetrahedra stuck = pyramid(Vec3(0.5, 0.25, 0));
  stuck.may_move[4] = 0;
  const Tetrahedra before = stuck;
  const ReferenceSurface surface(before.points, before.triangles, before.regions);
  improve_angles(stuck, surface, 25 * test::kDegree);
  EXPECT_EQ(stuck.points, before.points);
  Tetrahedra good = pyramid(Vec3(2, 2, 0));
  improve_angles(good, surface, 25 * test::kDegree);
  EXPECT_EQ(good.points, pyramid(Vec3(2, 2, 0)).points);
}

TEST(AngleImprovement, smallest_angle_is_that_of_the_triangle) {
  EXPECT_NEAR(smallest_angle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, std::sqrt(3), 0)),
              30 * test::kDegree, 1e-12);
  EXPECT_EQ(smallest_angle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)), 0);
}

}  // namespace
}  // namespace dupin::meshing
