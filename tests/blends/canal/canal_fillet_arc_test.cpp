#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

// A ball of radius 1 in the corner between two cylinders of radius 2 and 1 with axes along x and y.
const std::array<Ring, 2> kCylinders{Ring{Vec3(5, 0, 0), Vec3::UnitX(), 2},
                                     Ring{Vec3(0, -3, 0), Vec3::UnitY(), 1}};
const MovingBall kBall{Vec3(2, 3, 0), Vec3(0, 0, 4), Vec3(-1, -2, 0), 1, 0, 0};

TEST(ContactArc, OfABallInACorner) {
  const ContactArc arc = contact_arc(kCylinders, kBall);
  EXPECT_LT((arc.feet[0] - Vec3(2, 2, 0)).norm(), 1e-15);
  EXPECT_LT((arc.feet[1] - Vec3(1, 3, 0)).norm(), 1e-15);
  EXPECT_LT((arc.normals[0] - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_LT((arc.normals[1] - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_EQ(arc.center, kBall.center);
  EXPECT_EQ(arc.radius, 1);
  EXPECT_DOUBLE_EQ(arc.angle, kPi / 2);
  EXPECT_DOUBLE_EQ(arc.weight, 0.5);
  EXPECT_LT((arc.middle - Vec3(1, 2, 0)).norm(), 1e-15);
  EXPECT_LT((point(arc, 0) - arc.feet[0]).norm(), 1e-15);
  EXPECT_LT((point(arc, arc.angle) - arc.feet[1]).norm(), 1e-15);
}

TEST(ContactArc, LagsBehindABallThatGrows) {
  MovingBall ball = kBall;
  ball.radius_rate = 2;  // half its speed
  const ContactArc arc = contact_arc(kCylinders, ball);
  EXPECT_LT((arc.center - Vec3(2, 3, -0.5)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(arc.radius, std::sqrt(0.75));
}

TEST(ContactArc, OfCoincidingFeetIsAPoint) {
  const std::array<Ring, 2> equal{Ring{Vec3::Zero(), Vec3::UnitX(), 2},
                                  Ring{Vec3::Zero(), Vec3::UnitY(), 2}};
  const ContactArc arc =
      contact_arc(equal, {Vec3(0, 0, 3), Vec3(1, 1, 0), Vec3(0, 0, -1), 1, 0, 0});
  EXPECT_EQ(arc.angle, 0);
  EXPECT_EQ(arc.weight, 1);
  EXPECT_EQ(arc.feet[0], arc.feet[1]);
  EXPECT_EQ(point(arc, 0), arc.feet[1]);
  EXPECT_TRUE(arc.across.allFinite());
  EXPECT_NEAR(arc.across.norm(), 1, 1e-15);
}

TEST(ContactArc, OfNearlyCoincidingFeetHasTheRightAngle) {
  const double tilt = 1e-9;
  const std::array<Ring, 2> nearly{
      Ring{Vec3::Zero(), Vec3::UnitX(), 2},
      Ring{Vec3(0, 0, 3 - 3 * std::cos(tilt)) - 3 * std::sin(tilt) * Vec3::UnitX(), Vec3::UnitY(),
           2}};
  const ContactArc arc =
      contact_arc(nearly, {Vec3(0, 0, 3), Vec3(0, 1, 0), Vec3(0, 0, -1), 1, 0, 0});
  EXPECT_NEAR(arc.angle, tilt, 1e-15);
  EXPECT_LT((point(arc, arc.angle) - arc.feet[1]).norm(), 1e-15);
}

TEST(ContactArc, OnAConeIsOnItsPositiveNappe) {
  // 45 degrees: the ball touches it at height 1 from outside.
  const Ring cone{Vec3(0, 0, 3), Vec3::UnitZ(), 3, 1};
  const Ring cylinder{Vec3(2, 0, 0), Vec3::UnitX(), 1};
  const double root = std::sqrt(0.5);
  const ContactArc arc = contact_arc(
      {cone, cylinder}, {Vec3(1 + root, 0, 1 - root), Vec3(0, 1, 0), Vec3(-1, 0, 0), 1, 0, 0});
  EXPECT_LT((arc.feet[0] - Vec3(1, 0, 1)).norm(), 1e-14);
  EXPECT_LT((arc.normals[0] - Vec3(root, 0, -root)).norm(), 1e-14);
}

TEST(ContactArc, RefusesABallThatGrowsAsFastAsItMoves) {
  MovingBall ball = kBall;
  ball.radius_rate = 4;
  EXPECT_THROW((void)contact_arc(kCylinders, ball), Error);
  ball.velocity = Vec3::Zero();
  EXPECT_THROW((void)contact_arc(kCylinders, ball), Error);
}

TEST(ContactArc, RefusesEllipses) {
  std::array<Ring, 2> rings = kCylinders;
  rings[1].ellipse = Ellipse{Vec3::UnitX(), 3, 0};
  try {
    (void)contact_arc(rings, kBall);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
  }
}

TEST(LeastRegularity, IsAttainedAtAnEndOrInside) {
  const ContactArc arc = contact_arc(kCylinders, kBall);
  // 1 - m''.n / 16 on n from (0, -1) to (-1, 0): largest m''.n = 2 at the first foot, and
  // sqrt(5) between where the bend points into the arc.
  EXPECT_DOUBLE_EQ(least_regularity(kBall, arc), 1 - std::sqrt(5.0) / 16);
  MovingBall ball = kBall;
  ball.acceleration = Vec3(1, -2, 0);
  EXPECT_DOUBLE_EQ(least_regularity(ball, arc), 1 - 2.0 / 16);
  ball.acceleration = Vec3(-3, 2, 0);
  EXPECT_DOUBLE_EQ(least_regularity(ball, arc), 1 - 3.0 / 16);
  ball.acceleration = Vec3(-20, 0, 0);
  EXPECT_LT(least_regularity(ball, arc), 0);
}

TEST(LeastRegularity, IsTheLeastOverTheArcWhereTheRadiusChanges) {
  MovingBall ball = kBall;
  ball.radius_rate = 0.5;
  ball.radius_acceleration = 0.25;
  ball.acceleration = Vec3(-1, -2, 0.75);
  const ContactArc arc = contact_arc(kCylinders, ball);
  const double regularity = least_regularity(ball, arc);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= 1000; ++k) {
    const Vec3 n = (point(arc, arc.angle * k / 1000) - ball.center) / ball.radius;
    EXPECT_NEAR(n.norm(), 1, 1e-14);
    least = std::min(least, 1 - (0.25 + ball.acceleration.dot(n) + 0.25) / 16);
  }
  EXPECT_NEAR(regularity, least, 1e-6);
  EXPECT_LE(regularity, least + 1e-15);
}

}  // namespace
}  // namespace dupin
