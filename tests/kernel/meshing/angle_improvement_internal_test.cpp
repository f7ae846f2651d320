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
  mesh.freedoms.assign(6, Freedom::none);
  mesh.freedoms[4] = Freedom::region;
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
  const mesh::ReferenceSurface surface(before.points, before.triangles, before.regions);
  improve_angles(mesh, surface, 25 * test::kDegree, {4, 0.1});
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
  stuck.freedoms[4] = Freedom::none;
  const Tetrahedra before = stuck;
  const mesh::ReferenceSurface surface(before.points, before.triangles, before.regions);
  improve_angles(stuck, surface, 25 * test::kDegree, {4, 0.1});
  EXPECT_EQ(stuck.points, before.points);
  Tetrahedra good = pyramid(Vec3(2, 2, 0));
  improve_angles(good, surface, 25 * test::kDegree, {4, 0.1});
  EXPECT_EQ(good.points, pyramid(Vec3(2, 2, 0)).points);
}

TEST(AngleImprovement, moves_points_inside_out_of_slivers) {
  // An octahedron about a point nearly in one of its faces.
  Tetrahedra mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},         {0, -1, 0},
                 {0, 0, 1}, {0, 0, -1}, {0.33, 0.33, 0.32}};
  mesh.freedoms.assign(7, Freedom::none);
  mesh.freedoms[6] = Freedom::inside;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2);
    const bool turned = (x + y + z) % 2 == 1;
    mesh.triangles.push_back(turned ? Triangle{x, z, y} : Triangle{x, y, z});
    mesh.regions.push_back(i);
    mesh.tetrahedra.push_back(
        {6, mesh.triangles.back()[0], mesh.triangles.back()[1], mesh.triangles.back()[2]});
  }
  const Tetrahedra before = mesh;
  const auto least = [](const Tetrahedra& tetrahedra) {
    double angle = M_PI;
    for (const auto& [a, b, c, d] : tetrahedra.tetrahedra) {
      EXPECT_TRUE(is_positive(tetrahedra.points[a], tetrahedra.points[b], tetrahedra.points[c],
                              tetrahedra.points[d]));
      angle =
          std::min(angle, smallest_dihedral_angle({tetrahedra.points[a], tetrahedra.points[b],
                                                   tetrahedra.points[c], tetrahedra.points[d]}));
    }
    return angle;
  };
  ASSERT_LT(least(before), 5 * test::kDegree);
  const mesh::ReferenceSurface surface(before.points, before.triangles, before.regions);
  improve_dihedral_angles(mesh, surface, 30 * test::kDegree, 0, {2, 0.1});
  EXPECT_GE(least(mesh), 30 * test::kDegree);
}

TEST(AngleImprovement, smallest_dihedral_angle_is_that_between_two_faces) {
  EXPECT_NEAR(smallest_dihedral_angle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}),
              std::acos(1 / std::sqrt(3)), 1e-12);
  EXPECT_NEAR(
      smallest_dihedral_angle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 1e-3)}),
      std::atan(1e-3 / 0.3), 1e-4);
}

TEST(AngleImprovement, smallest_angle_is_that_of_the_triangle) {
  EXPECT_NEAR(smallest_angle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, std::sqrt(3), 0)),
              30 * test::kDegree, 1e-12);
  EXPECT_EQ(smallest_angle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)), 0);
}

}  // namespace
}  // namespace dupin::meshing
