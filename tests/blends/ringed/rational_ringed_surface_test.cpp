#include "dupin/blends/rational_ringed_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

using test::cone_to_cylinder;
using test::end_cone;
using test::general_ends;
using test::start_cone;

TEST(RationalRingedSurface, has_the_derivatives_of_its_points) {
  const RationalRingedSurface s = general_ends();
  const double h = 1e-5;
  for (const double t : {.2, .7}) {
    for (const double v : {.5, 3.}) {
      const SurfacePoint x = evaluate(s, t, v);
      const auto at = [&](double a, double b) { return evaluate(s, a, b).position; };
      EXPECT_LT(((at(t + h, v) - at(t - h, v)) / (2 * h) - x.along).norm(), 1e-7);
      EXPECT_LT(((at(t, v + h) - at(t, v - h)) / (2 * h) - x.around).norm(), 1e-8);
      EXPECT_LT((x.around.cross(x.along).normalized() - x.normal).norm(), 1e-13);
    }
  }
}

TEST(RationalPatch, is_the_surface_exactly) {
  for (const RationalRingedSurface& s :
       {cone_to_cylinder(), canal_ringed_blend(start_cone(), end_cone())}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double v0 = quarter * kPi / 2, v1 = v0 + kPi / 2;
      const RationalPatch patch = rational_patch(s, v0, v1);
      EXPECT_EQ(patch.net.size(), s.rotation.size() == 2 ? 6u : 10u);
      for (int i = 0; i <= 5; ++i) {
        for (int j = 0; j <= 5; ++j) {
          const double t = i / 5., w = j / 5.;
          const Vec3 x = evaluate(patch, t, w);
          // The angle of a rational quadratic's parameter.
          const double half = (v1 - v0) / 2;
          const double angle = v0 + half + 2 * std::atan((2 * w - 1) * std::tan(half / 2));
          EXPECT_LT((x - evaluate(s, t, angle).position).norm(), 1e-13);
        }
      }
    }
  }
}

TEST(RationalPatch, of_the_table_has_its_least_weight) {
  double least = 1;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const RationalPatch patch =
        rational_patch(cone_to_cylinder(), quarter * kPi / 2, (quarter + 1) * kPi / 2);
    for (const auto& row : patch.net) {
      for (const auto& point : row) {
        least = std::min(least, point[3]);
      }
    }
  }
  EXPECT_NEAR(least, 0.5690355937, 6e-11);
}

TEST(RationalRinged, margins_to_prove_are_numbers) {
  const RationalRingedTube tube = oblique_tube({0, 0, 0}, {1, 0, 5}, {0, 0, 1}, 1, 2);
  EXPECT_TRUE(proves_regular(tube.surface, 0.5));
  for (const double margin : {std::nan(""), double(INFINITY), -double(INFINITY)}) {
    EXPECT_THROW((void)proves_regular(tube.surface, margin), Error);
  }
}

}  // namespace
}  // namespace dupin
