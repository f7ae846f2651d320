#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "canal/contact_feet.h"
#include "dupin/kernel/error.h"

namespace dupin::canal {
namespace {

// Cylinders of radius 2 and 1 with axes along x and y.
const std::array<Ring, 2> kCylinders{Ring{Vec3(5, 0, 0), Vec3::UnitX(), 2},
                                     Ring{Vec3(0, -3, 0), Vec3::UnitY(), 1}};

TEST(ContactFeet, are_those_of_the_arc) {
  for (const double rate : {-.9, 0.0, .5}) {
    for (const double slope : {0.0, .25}) {
      std::array<Ring, 2> quadrics = kCylinders;
      quadrics[1].slope = slope;
      const MovingBall ball{Vec3(2, 3, .5), Vec3(0, .6, .8), Vec3(-1, -2, 0), 1, rate, 0};
      const auto feet = contact_feet(quadrics, ball);
      EXPECT_EQ(feet, contact_arc(quadrics, ball).feet);
      EXPECT_EQ(radius_lag(ball), rate);
      for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 normal = normal_at_foot(quadrics[i], ball);
        EXPECT_NEAR(normal.norm(), 1, 1e-15);
        EXPECT_LT((feet[i] + normal - ball.center).norm(), 1e-15);
      }
    }
  }
}

TEST(ContactFeet, are_none_where_nothing_is_enveloped) {
  for (const double rate : {1.0, -2.0, std::numeric_limits<double>::quiet_NaN()}) {
    const MovingBall ball{Vec3(2, 3, 0), Vec3::UnitZ(), Vec3::Zero(), 1, rate, 0};
    EXPECT_THROW((void)contact_feet(kCylinders, ball), Error) << rate;
  }
  std::array<Ring, 2> elliptic = kCylinders;
  elliptic[0].ellipse = Ellipse{Vec3::UnitY(), 1};
  const MovingBall ball{Vec3(2, 3, 0), Vec3::UnitZ(), Vec3::Zero(), 1, 0, 0};
  EXPECT_THROW((void)contact_feet(elliptic, ball), Error);
}

}  // namespace
}  // namespace dupin::canal
