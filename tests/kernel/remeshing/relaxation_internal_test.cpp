#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/relaxation.h"
#include "remeshing/steps.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

TEST(Relaxation, makes_angles_larger_and_stays_on_the_surface) {
  Bench bench(dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1)), {0.001, 0.2, 0.001});
  while (split_long_edges(bench.shop) > 0) {
    flip_edges(bench.shop);
  }
  const double before = test::smallest_sine_of(bench.working);
  for (int i = 0; i < 3; ++i) {
    relax_points(bench.shop);
    flip_edges(bench.shop);
  }
  bench.shop.least_sine = std::sin(0.6);
  widen_angles(bench.shop);
  EXPECT_GE(test::smallest_sine_of(bench.working), before);
  EXPECT_GE(test::smallest_sine_of(bench.working), std::sin(0.44));
  const WorkingMesh& mesh = bench.working;
  for (std::uint32_t v = 0; v < mesh.point_count(); ++v) {
    const Vec3 off = (mesh.place(v) - Vec3(0.5, 0.5, 0.5)).cwiseAbs();
    EXPECT_NEAR(off.maxCoeff(), 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace dupin::remeshing
