#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "canal/ball_on_cylinders.h"

namespace dupin::canal {
namespace {

using numbers::Interval;

Ring ring(const Vec3& center, const Vec3& normal, double radius, double slope = 0) {
  return {center, normal.normalized(), radius, slope};
}

double sampled(const CanalFillet& fillet, double parameter) {
  const MovingBall at = ball(fillet, parameter);
  return least_regularity(at, contact_arc(fillet.quadrics, at));
}

// Pipes of which the second passes through the first, or all but, touches it, is as thick, or
// neither passes; with small and large balls, and with the quadrics in another order.
std::vector<CanalFillet> loops() {
  const Vec3 n(.48, .6, .64), b = Vec3(.1, 1, -.4).normalized(), up = n.cross(b).normalized();
  const Vec3 c(7, -3, 2);
  const Ring run = ring(c, n, 2);
  std::vector<CanalFillet> result;
  for (const double radius : {.01, .4, 3.0}) {
    for (const Ring& branch :
         {ring(c + .3 * up, b, 1), ring(c - up, b, 1), ring(c + (1 + 1e-7) * up, -b, 1),
          ring(c + (1 - 1e-7) * up, b, 1), ring(c + 3 * b, b, 2), ring(c + 1.2 * up, b, 1),
          ring(c - 2.9 * up, b, 1), ring(c + .1 * up, n + .3 * b, 1.5)}) {
      for (CanalFillet& loop : rolling_ball_fillets({run, branch}, radius, 0x1p-33)) {
        result.push_back(loop);
        std::swap(loop.quadrics[0], loop.quadrics[1]);
        result.push_back(std::move(loop));
      }
    }
  }
  return result;
}

TEST(BallOnCylinders, HoldsTheRegularityAtEveryPlaceOfAStretch) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> parameter(-3, 3), share(0, 1);
  for (const CanalFillet& loop : loops()) {
    const auto rolling = BallOnCylinders::of(loop);
    ASSERT_TRUE(rolling);
    for (int i = 0; i < 40; ++i) {
      const double from = parameter(random);
      for (const double length : {.5, 1e-2, 1e-4}) {
        const Interval over = rolling->least_regularity({from, from + length});
        for (int k = 0; k < 4; ++k) {
          const double t = from + share(random) * length, there = sampled(loop, t);
          const double rounding = 1e-7 * (1 + std::abs(1 - there));
          EXPECT_LE(over.lower, there + rounding);
          EXPECT_GE(over.upper, there - rounding);
        }
      }
    }
  }
}

TEST(BallOnCylinders, IsNarrowAtAPlace) {
  const Ring run = ring({0, 0, 0}, {1, 0, 0}, 2);
  for (const Ring& branch : {ring({0, 0, .3}, {.6, .8, 0}, 1), ring({0, 0, 1.5}, {.6, .8, 0}, 1),
                             ring({0, 0, 0}, {.6, .8, 0}, 2)}) {
    for (const CanalFillet& loop : rolling_ball_fillets({run, branch}, .5)) {
      const auto rolling = BallOnCylinders::of(loop);
      ASSERT_TRUE(rolling);
      for (const double t : {-2.9, -1.3, .2, 1.4, 2.0}) {
        const Interval at = rolling->least_regularity({t, t});
        EXPECT_NEAR(at.lower, sampled(loop, t), 1e-11);
        EXPECT_NEAR(at.upper, sampled(loop, t), 1e-11);
      }
    }
  }
}

// What is off by rounding is bounded, and what is off by more is not told of.
TEST(BallOnCylinders, TellsNothingWhereTheBallIsOffTheCylinders) {
  const Ring run = ring({0, 0, 0}, {1, 0, 0}, 2), branch = ring({0, 0, .3}, {.6, .8, 0}, 1);
  const CanalFillet loop = rolling_ball_fillets({run, branch}, .5)[0];
  const Interval known = BallOnCylinders::of(loop)->least_regularity({1, 1});
  const auto wider = [&](double off) {
    CanalFillet other = loop;
    other.quadrics[1].center.z() += off;
    const auto rolling = BallOnCylinders::of(other);
    return rolling && rolling->least_regularity({1, 1}).upper > known.upper + off / 10;
  };
  EXPECT_TRUE(wider(1e-12));
  EXPECT_TRUE(wider(1e-11));
  for (const auto& spoil :
       {+[](CanalFillet& f) { f.quadrics[0].radius += 1e-6; },
        +[](CanalFillet& f) { f.quadrics[0].slope = 1e-9; },
        +[](CanalFillet& f) { f.quadrics[1].normal.x() += 1e-6; },
        +[](CanalFillet& f) { f.quadrics[1].center.z() += 1e-6; },
        +[](CanalFillet& f) { std::get<RollingThrough>(f.motion).up.y() += 1e-6; }}) {
    CanalFillet other = loop;
    spoil(other);
    EXPECT_FALSE(BallOnCylinders::of(other));
  }
  EXPECT_FALSE(BallOnCylinders::of(rational_fillets({run, branch}, .5)[0]));
}

}  // namespace
}  // namespace dupin::canal
