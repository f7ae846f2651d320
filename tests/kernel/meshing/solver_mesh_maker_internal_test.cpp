#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "meshing/solver_mesh_maker.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

const Solid kTube = Solid::from(test::labelled(test::tube(5, 0, 20, 48), "tube"));

TEST(SolverMeshMaker, surface_is_that_of_the_tetrahedra) {
  const SolverMesh made = make_solver_mesh(kTube, {.distance = 0.1}, true);
  EXPECT_EQ(made.surface.nearest_points(), made.mesh.surface.points);
  EXPECT_EQ(made.surface.triangles(), made.mesh.surface.triangles);
  EXPECT_LT(made.surface.point_count(), made.mesh.point_count());
  EXPECT_EQ(made.surface.names(), kTube.names());
  EXPECT_EQ(made.surface.labels().size(), made.surface.triangle_count());
}

TEST(SolverMeshMaker, asks_for_less_until_the_distance_is_proved) {
  for (const double distance : {0.5, 0.05}) {
    const SolverMesh made = make_solver_mesh(kTube, {.distance = distance}, false);
    EXPECT_LE(made.report.deviation, distance);
    EXPECT_GT(made.report.deviation, 0);
  }
}

TEST(SolverMeshMaker, gives_up_where_points_are_too_few) {
  try {
    (void)make_solver_mesh(kTube, {.distance = 0.001, .most_points = 200}, false);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
}

TEST(SolverMeshMaker, joins_a_sliver_of_a_patch_to_the_patch_beside_it) {
  const Solid strip = unite(std::vector{
      kTube, Solid::from(test::labelled(test::tube(5, 20, 20 + 0x1p-8, 48), "sliver"))});
  ASSERT_EQ(strip.names().size(), 2U);
  const SolverMesh made = make_solver_mesh(strip, {.distance = 0.1}, false);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_LE(made.report.deviation, 0.1);
}

}  // namespace
}  // namespace dupin::meshing
