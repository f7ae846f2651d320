#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "canal/straight_pipe.h"

namespace dupin::canal {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

RingedSurface tube(double radius, double end_radius) {
  const double slope = (end_radius - radius) / 10;
  const Ring start{Vec3::Zero(), -Vec3::UnitX(), radius, -slope};
  const Ring end{Vec3(10, 0, 0), Vec3::UnitX(), end_radius, slope};
  return {start, end, LineSpine{start.center, end.center}, LinearRadius{radius, end_radius}};
}

std::vector<Vec3> circle(double height, double radius, double tilt = 0) {
  std::vector<Vec3> result;
  for (int i = 0; i < 64; ++i) {
    const double t = kTurn * i / 64;
    result.emplace_back(height + tilt * std::cos(t), radius * std::cos(t), radius * std::sin(t));
  }
  return result;
}

TEST(StraightPipe, knows_where_loops_lie_on_it) {
  const RingedSurface pipe = tube(2, 2);
  const std::string name = "a";
  const StraightPipe straight(pipe, name, 0.5);
  EXPECT_EQ(straight.length(), 10);
  EXPECT_EQ(straight.said(2), 1.5);
  const Course within = straight.course(circle(5, 2, 1));
  EXPECT_TRUE(within.winds);
  EXPECT_EQ(within.height.least, 4);
  EXPECT_EQ(within.height.most, 6);
  EXPECT_EQ(straight.place(within, {}), Place::within);
  EXPECT_EQ(straight.place(straight.course(circle(12, 2, 1)), {}), Place::beside);
  const Course over = straight.course(circle(10, 2, 1));
  EXPECT_EQ(straight.place(over, {}), Place::across);
  EXPECT_EQ(straight.place(over, {false, true}), Place::beside);  // beyond what is buried
}

TEST(StraightPipe, buries_discs_that_touch_it_from_inside) {
  const RingedSurface cone = tube(2, 3);
  const std::string name = "a";
  const StraightPipe straight(cone, name, 0);
  EXPECT_NEAR(straight.outside({5, 4, 0}), 1.5, 1e-15);
  EXPECT_EQ(straight.outside({-1, 0, 0}), 1);
  Ring disc{Vec3(5, 0, 0), Vec3::UnitX(), 2.5};
  EXPECT_TRUE(straight.buries(disc));
  EXPECT_NEAR(straight.reach_out(disc), 0, 1e-15);
  disc.radius = 2.6;
  EXPECT_FALSE(straight.buries(disc));
  EXPECT_NEAR(straight.reach_out(disc), 0.1, 1e-12);
}

}  // namespace
}  // namespace dupin::canal
