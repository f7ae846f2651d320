#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "kernel/meshing/plane_internal.h"
#include "meshing/edge_edits.h"

namespace dupin::meshing {
namespace {

double smallest(const Tetrahedra& mesh) {
  double least = M_PI;
  for (const auto& [a, b, c] : mesh.triangles) {
    least = std::min(least, smallest_angle(mesh.points[a], mesh.points[b], mesh.points[c]));
  }
  return least;
}

Tetrahedra mesh_of(std::vector<Vec3> points, std::vector<Triangle> triangles,
                   std::uint32_t inner_point) {
  Tetrahedra mesh{std::move(points), {}, {}, std::move(triangles), {}};
  mesh.freedoms.assign(mesh.points.size(), Freedom::none);
  if (inner_point < mesh.points.size()) {
    mesh.freedoms[inner_point] = Freedom::region;
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  return mesh;
}

const std::vector<BorderChain> kRim = {{{0, 1, 2, 3, 0}, 1}};

TEST(EdgeEdits, turn_the_long_diagonal_of_a_rhombus) {
  const Plane plane;
  Tetrahedra mesh =
      mesh_of({{0, 0, 0}, {2, -0.6, 0}, {4, 0, 0}, {2, 0.6, 0}}, {{0, 1, 2}, {0, 2, 3}}, 9);
  EXPECT_TRUE(edit_edges(mesh, plane.surface, kRim, 25 * kDegree, kLimits));
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_GT(smallest(mesh), 30 * kDegree);
  EXPECT_FALSE(edit_edges(mesh, plane.surface, kRim, 25 * kDegree, kLimits)) << "nothing is poor";
}

TEST(EdgeEdits, leave_edges_of_chains) {
  const Plane plane;
  Tetrahedra mesh =
      mesh_of({{0, 0, 0}, {2, -0.6, 0}, {4, 0, 0}, {2, 0.6, 0}}, {{0, 1, 2}, {0, 2, 3}}, 9);
  std::vector<BorderChain> chains = kRim;
  chains.push_back({{0, 2}, 2});
  EXPECT_FALSE(edit_edges(mesh, plane.surface, chains, 25 * kDegree, kLimits));
}

TEST(EdgeEdits, draw_the_point_that_cuts_a_wedge_into_its_border) {
  // A wedge of 20 degrees at 0, cut in two by a point on its bisector.
  const double s = std::sin(10 * kDegree), c = std::cos(10 * kDegree);
  const Plane plane;
  Tetrahedra mesh = mesh_of({{0, 0, 0}, {c, -s, 0}, {c + 0.3, 0, 0}, {c, s, 0}, {1, 0, 0}},
                            {{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {4, 2, 3}}, 4);
  ASSERT_LT(smallest(mesh), 11 * kDegree);
  EXPECT_TRUE(edit_edges(mesh, plane.surface, kRim, 25 * kDegree, kLimits));
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.regions.size(), 2U);
  EXPECT_NEAR(smallest(mesh), 20 * kDegree, 1e-9);
}

TEST(EdgeEdits, leave_what_would_be_far_from_the_surface) {
  // The rhombus bent along its long diagonal: the other one is in the air.
  const std::vector<Vec3> points = {{0, 0, 0}, {2, -0.6, 0.5}, {4, 0, 0}, {2, 0.6, 0.5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<std::uint32_t> regions = {0, 0};
  const mesh::ReferenceSurface surface(points, triangles, regions);
  Tetrahedra mesh = mesh_of(points, triangles, 9);
  EXPECT_FALSE(edit_edges(mesh, surface, kRim, 25 * kDegree, kLimits));
  EXPECT_TRUE(edit_edges(mesh, surface, kRim, 25 * kDegree, {100, 1}));
}

}  // namespace
}  // namespace dupin::meshing
