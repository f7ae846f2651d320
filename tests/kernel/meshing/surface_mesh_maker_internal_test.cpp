#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "kernel/meshing/solver_mesh_checks.h"
#include "meshing/surface_mesh_maker.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

Solid hollow(double thickness) {
  return subtract(
      Solid::from(test::labelled(test::tube(10, 0, 60, 64), "wall")),
      std::vector{Solid::from(test::labelled(test::tube(10 - thickness, -1, 61, 64), "bore"))});
}

SolverMesh made(const Solid& solid, const RemeshOptions& options) {
  const GivenSolid given(solid, options);
  return make_surface_mesh(given);
}

TEST(SurfaceMeshMaker, does_not_mind_how_thin_a_wall_is) {
  const SolverMesh thick = made(hollow(4), {.distance = 0.2, .largest_edge = 8}),
                   thin = made(hollow(0.5), {.distance = 0.2, .largest_edge = 8});
  EXPECT_LE(thin.report.deviation, 0.2);
  EXPECT_EQ(thin.surface.euler_number(), 0);
  EXPECT_EQ(thin.report.poor_triangles, 0U);
  // But for the rims, where both sides are.
  EXPECT_LE(thin.surface.triangle_count(), 2 * thick.surface.triangle_count());
}

TEST(SurfaceMeshMaker, parts_sides_of_a_wall_that_the_distance_would_let_meet) {
  const SolverMesh thin = made(hollow(0.1), {.distance = 0.4, .largest_edge = 8});
  EXPECT_LE(thin.report.deviation, 0.4);
  EXPECT_EQ(thin.surface.euler_number(), 0);
}

TEST(SurfaceMeshMaker, is_the_same_for_any_number_of_threads) {
  const Solid solid = hollow(2);
  const SolverMesh many = made(solid, {.distance = 0.2});
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const SolverMesh one = made(solid, {.distance = 0.2});
  EXPECT_EQ(many.mesh.surface.points, one.mesh.surface.points);
  EXPECT_EQ(many.mesh.surface.triangles, one.mesh.surface.triangles);
  EXPECT_EQ(many.mesh.surface.labels, one.mesh.surface.labels);
}

}  // namespace
}  // namespace dupin::meshing
