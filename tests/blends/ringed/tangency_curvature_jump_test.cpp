#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/tangency.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr End kStart = End::start, kEnd = End::end;

TEST(CurvatureJump, of_a_cubic_blend_is_its_spines_curvature_and_the_radius_laws) {
  // At theta = pi the normal curvature is (R'' / (v q)) + kappa v / q with q = v (1 + kappa R); the
  // bound looks at both signs apart, so it may exceed it by the width of q's range.
  const RingedSurface surface = test::figure6();
  const double kappa = curvature(evaluate(surface.spine, 0)), v = 10, rise = 6;
  const double largest = kappa / (1 - kappa) + rise / (v * v * (1 - kappa) * (1 - kappa));
  const double bound = curvature_jump_bound(surface, kStart);
  EXPECT_GE(bound, kappa / (1 - kappa) - rise / (v * v * (1 - kappa) * (1 - kappa)));
  EXPECT_LE(bound, largest * std::pow((1 + kappa) / (1 - kappa), 3));
}

TEST(CurvatureJump, refuses_an_end_that_folds) {
  RingedSurface surface = test::figure6();
  surface.radius = ConstantRadius{3};  // 1 - kappa R < 0 at the start
  EXPECT_THROW((void)curvature_jump_bound(surface, kStart), Error);
}

TEST(CurvatureJump, of_an_elbow_is_at_least_that_of_its_inside) {
  const double bend = 4, radius = 1;
  const RingedSurface elbow{{},
                            {},
                            ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(bend, 0, 0), 1.5},
                            ConstantRadius{radius}};
  for (const End end : {kStart, kEnd}) {
    // kappa / (1 - kappa R) inside; the bound lets q = v (1 -+ kappa R) vary on its own.
    const double x = radius / bend, bound = curvature_jump_bound(elbow, end);
    EXPECT_GE(bound, 1 / (bend - radius));
    EXPECT_LE(bound, std::pow((1 + x) / (1 - x), 2) / (bend - radius) * (1 + 1e-13));
  }
}

TEST(CurvatureJump, of_straight_tubes_is_that_of_their_radius) {
  const LineSpine line{Vec3(0, 0, 0), Vec3(2, 0, 0)};
  EXPECT_LT(curvature_jump_bound({{}, {}, line, LinearRadius{1, 3}}, kEnd), 1e-300);
  // R'' / v^2 where R' = 0: 6 (end - start) / 4.
  const double bound = curvature_jump_bound({{}, {}, line, CubicRadius{1, 1.5}}, kStart);
  EXPECT_GE(bound, .75);
  EXPECT_LT(bound, .75 * (1 + 1e-13));
}

TEST(CurvatureJump, refuses_a_spine_that_stops) {
  const RingedSurface surface{
      {}, {}, BezierSpine{{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}}, ConstantRadius{1}};
  EXPECT_THROW((void)curvature_jump_bound(surface, kStart), Error);
  EXPECT_NO_THROW((void)curvature_jump_bound(surface, kEnd));
}

}  // namespace
}  // namespace dupin
