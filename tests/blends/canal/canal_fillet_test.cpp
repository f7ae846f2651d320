#include "dupin/blends/canal_fillet.h"

#include <gtest/gtest.h>

#include "blends/canal/residuals.h"

namespace dupin {
namespace {

using test::kPi;

// Equal cylinders: the centres are (1.5 cos, 1.5 |cos|, 1.5 sin).
const CanalFillet kEqual{
    {Ring{Vec3::Zero(), Vec3::UnitX(), 1}, Ring{Vec3::Zero(), Vec3::UnitY(), 1}},
    RollingThrough{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), 0, 1, 1.5, 0, 0, 0, 1,
                   .5}};

TEST(CanalFillet, GivesTheBallAndItsMotion) {
  const MovingBall at = ball(kEqual, 1);
  EXPECT_LT((at.center - 1.5 * Vec3(std::cos(1), std::cos(1), std::sin(1))).norm(), 1e-15);
  EXPECT_LT((at.velocity - 1.5 * Vec3(-std::sin(1), -std::sin(1), std::cos(1))).norm(), 1e-15);
  EXPECT_LT((at.acceleration + at.center).norm(), 2e-15);
  EXPECT_EQ(at.radius, .5);
  EXPECT_EQ(at.radius_rate, 0);
  EXPECT_EQ(at.radius_acceleration, 0);
}

TEST(CanalFillet, DerivativesAtCornersAreThoseOfOneSide) {
  EXPECT_EQ(corners(kEqual), (std::vector<double>{-kPi / 2, kPi / 2}));
  const Vec3 right = ball(kEqual, kPi / 2).velocity;
  EXPECT_LT((right - Vec3(-1.5, 1.5, 0)).norm(), 1e-15);
  const Vec3 left = ball(kEqual, std::nextafter(kPi / 2, 0)).velocity;
  EXPECT_LT((left - Vec3(-1.5, -1.5, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace dupin
