#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using std::numbers::pi;

const Vec3 kFrom(1, 0, 2), kTo(4, 2, 6), kNormal(0, 0, 3);

TEST(ObliqueTube, is_the_linear_interpolation_of_its_circles) {
  const RationalRingedTube tube = oblique_tube(kFrom, kTo, kNormal, 1, .5);
  for (const double t : {0., .3, 1.}) {
    const double radius = std::lerp(1, .5, t);
    const Vec3 center = kFrom + t * (kTo - kFrom);
    for (double v = 0; v < 6; v += .7) {
      const Vec3 x = evaluate(tube.surface, t, v).position - center;
      EXPECT_NEAR(x.norm(), radius, 1e-14);
      EXPECT_NEAR(x.z(), 0, 1e-14);
    }
  }
}

// Cavalieri: the volume depends on the height alone.
TEST(ObliqueTube, holds_the_volume_of_the_right_one) {
  const double height = 4;
  EXPECT_NEAR(volume(oblique_tube(kFrom, kTo, kNormal, 1, 1).surface), pi * height, 1e-13);
  EXPECT_NEAR(volume(oblique_tube(kFrom, kTo, kNormal, 1, .5).surface),
              pi * height * (1 + .5 + .25) / 3, 1e-13);
}

TEST(ObliqueTube, stores_rings_that_look_out_of_it_with_their_slopes) {
  const RationalRingedTube tube = oblique_tube(kFrom, kTo, kNormal, 1, .5);
  EXPECT_EQ(tube.start.center, kFrom);
  EXPECT_EQ(tube.end.center, kTo);
  EXPECT_EQ(tube.start.normal, -Vec3::UnitZ());
  EXPECT_EQ(tube.end.normal, Vec3::UnitZ());
  EXPECT_EQ(tube.start.radius, 1);
  EXPECT_EQ(tube.end.radius, .5);
  EXPECT_EQ(tube.end.slope, -.125);
  EXPECT_EQ(tube.start.slope, .125);
}

TEST(ObliqueTube, refuses_what_is_none) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)oblique_tube(kFrom, kTo, Vec3(0, 0, 0), 1, 1), Error);
  EXPECT_THROW((void)oblique_tube(kFrom, kTo, Vec3(4, 0, -3), 1, 1), Error);  // across the way
  EXPECT_THROW((void)oblique_tube(kFrom, kFrom, kNormal, 1, 1), Error);
  EXPECT_THROW((void)oblique_tube(kFrom, Vec3(none, 0, 0), kNormal, 1, 1), Error);
  EXPECT_THROW((void)oblique_tube(kFrom, kTo, kNormal, 0, 1), Error);
  EXPECT_THROW((void)oblique_tube(kFrom, kTo, kNormal, 1, -1), Error);
}

TEST(MovingRing, reversed_twice_is_the_same_motion) {
  const MovingRing ring{Vec3(1, 2, 3), Vec3::UnitX(), 2, Vec3(3, 1, 0), -.5, Vec3(0, .25, 0)};
  const MovingRing back = reversed(ring);
  EXPECT_EQ(back.center, ring.center);
  EXPECT_EQ(back.normal, -ring.normal);
  EXPECT_EQ(back.center_rate, -ring.center_rate);
  EXPECT_EQ(back.radius_rate, .5);
  EXPECT_EQ(back.normal_rate, ring.normal_rate);  // both the normal and the sense change sign
  const MovingRing twice = reversed(back);
  EXPECT_EQ(twice.normal, ring.normal);
  EXPECT_EQ(twice.center_rate, ring.center_rate);
  EXPECT_EQ(twice.radius_rate, ring.radius_rate);
}

TEST(MovingRing, at_another_speed_has_all_its_rates_multiplied) {
  const MovingRing ring{Vec3(1, 2, 3), Vec3::UnitX(), 2, Vec3(3, 1, 0), -.5, Vec3(0, .25, 0)};
  const MovingRing fast = at_speed(ring, 4);
  EXPECT_EQ(fast.center_rate, Vec3(12, 4, 0));
  EXPECT_EQ(fast.radius_rate, -2);
  EXPECT_EQ(fast.normal_rate, Vec3(0, 1, 0));
  EXPECT_EQ(fast.center, ring.center);
  EXPECT_EQ(fast.radius, ring.radius);
}

}  // namespace
}  // namespace dupin
