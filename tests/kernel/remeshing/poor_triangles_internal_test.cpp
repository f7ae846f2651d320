#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/poor_triangles.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

TEST(PoorTriangles, between_sharp_edges_are_told_apart) {
  // A wedge of 10 degrees: its ends have a corner that no triangle can better.
  TriMesh wedge;
  const double far = std::tan(M_PI / 18);
  wedge.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, far, 0),
                  Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, far, 1)};
  wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                     {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const Bench bench(wedge, {0.01, 1, 0.01});
  const RemeshReport report =
      PoorTriangles(bench.working, bench.features, 25 * M_PI / 180, 0.01).report();
  EXPECT_EQ(report.poor_triangles, 4U);
  EXPECT_EQ(report.confined_triangles, 2U);
  ASSERT_EQ(report.worst.size(), 4U);
  EXPECT_FALSE(report.worst[0].is_confined);
  EXPECT_TRUE(report.worst[3].is_confined);
  EXPECT_NEAR(report.worst[3].angle, M_PI / 18, 1e-12);
  EXPECT_NEAR(report.smallest_angle, std::atan(far), 1e-12);
}

}  // namespace
}  // namespace dupin::remeshing
