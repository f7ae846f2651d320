#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::least_margin;

// The least 1 - rho |n'| / d'.n of samples.
double sampled_margin(const RationalRingedSurface& surface) {
  double least = 1;
  for (int i = 0; i <= 400; ++i) {
    const MovingRing ring = ring_at(surface, i / 400.);
    least = std::min(least,
                     1 - ring.radius * ring.normal_rate.norm() / ring.center_rate.dot(ring.normal));
  }
  return least;
}

// Discs of radius rho on a straight way, which do not turn.
RationalRingedSurface straight(const std::array<double, 4>& radius) {
  return {{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 2), Vec3(0, 0, 3)},
          radius,
          {{std::sqrt(.5), 0, -std::sqrt(.5), 0}, {std::sqrt(.5), 0, -std::sqrt(.5), 0}}};
}

TEST(RationalRingedSurface, is_proven_regular_only_where_its_margin_is_positive) {
  std::mt19937_64 random(20068);
  std::normal_distribution<double> gauss;
  int regular = 0, irregular = 0;
  for (int i = 0; i < 60; ++i) {
    const auto ring = [&] {
      const Vec3 normal = Vec3(gauss(random), gauss(random), gauss(random)).normalized();
      return MovingRing{3 * Vec3(gauss(random), gauss(random), gauss(random)), normal, 1,
                        6 * normal, gauss(random)};
    };
    const MovingRing from = ring(), to = ring();
    bool proven = true;
    RationalRingedSurface surface;
    try {
      surface = ringed_blend(from, to);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::irregular_surface);
      proven = false;
    }
    ++(proven ? regular : irregular);
    if (proven) {
      EXPECT_GT(least_margin(surface), 0);
    }
  }
  EXPECT_GT(regular, 5);
  EXPECT_GT(irregular, 5);
}

TEST(RingedRegularity, certified_margin_is_within_a_step_of_the_samples) {
  for (const RationalRingedSurface& surface :
       {test::cone_to_cylinder(), test::general_ends(),
        canal_ringed_blend(test::start_cone(), test::end_cone())}) {
    const double found = certified_margin(surface), sampled = sampled_margin(surface);
    EXPECT_LE(found, sampled);
    EXPECT_GT(found, sampled - 1. / 128);
    EXPECT_TRUE(proves_regular(surface, found));
    EXPECT_FALSE(proves_regular(surface, sampled + 1e-6));
  }
}

TEST(RingedRegularity, of_discs_that_do_not_turn_is_that_of_their_radii) {
  EXPECT_TRUE(proves_regular(straight({1, 1, 1, 1}), .99));
  EXPECT_EQ(certified_margin(straight({1, 2, .5, 1})), 255. / 256);
  EXPECT_TRUE(proves_regular(straight({1, -.3, -.3, 1})));     // control points only are negative
  EXPECT_FALSE(proves_regular(straight({1, -.34, -.34, 1})));  // (2 - 2.04) / 8 in the middle
  EXPECT_FALSE(proves_regular(straight({1, 1, 1, 0})));
  RationalRingedSurface back = straight({1, 1, 1, 1});
  back.center[1] = Vec3(0, 0, 3);  // and back again
  back.center[2] = Vec3(0, 0, 0);
  EXPECT_FALSE(proves_regular(back));
}

TEST(RingedRegularity, is_that_of_the_limit_where_a_plate_lets_the_ring_stand) {
  const auto out_of_plate = ringed_blend(along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 2}, -3),
                                         along_canal({Vec3(.5, 0, 4), Vec3::UnitZ(), 1}, 0, 4));
  EXPECT_TRUE(proves_regular(out_of_plate, .5));
  RationalRingedSurface resting = out_of_plate;
  resting.radius[1] = resting.radius[0];  // now nothing moves at the start
  EXPECT_FALSE(proves_regular(resting));
}

}  // namespace
}  // namespace dupin
