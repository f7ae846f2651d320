#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "canal/fillet_wall.h"

namespace dupin::canal {
namespace {

// A run along x, and a branch at an angle to it.
std::vector<CanalFillet> fillets(double run, double branch, double angle, double ball) {
  const Vec3 along(std::cos(angle), 0, std::sin(angle));
  return rolling_ball_fillets(
      {Ring{Vec3::Zero(), Vec3::UnitX(), run}, Ring{100 * along, along, branch}}, ball);
}

constexpr double kSlant = std::numbers::pi / 4;

TEST(BreaksThrough, is_a_matter_of_the_wall_where_balls_are_concentric) {
  const auto inner = fillets(26, 11, kSlant, 9), outer = fillets(30, 15, kSlant, 5);
  EXPECT_FALSE(breaks_through(inner, outer));
  EXPECT_FALSE(breaks_through(inner, outer, 3.999));
  EXPECT_TRUE(breaks_through(inner, outer, 4.001));
}

// Walls of 4 and 1: the centres are 3 / sin of the angle between the pipes apart where these meet
// in the plane of their axes, and the radii 4. Upright, 1 is left.
TEST(BreaksThrough, is_where_walls_differ_and_pipes_are_aslant) {
  const double right = std::numbers::pi / 2;
  EXPECT_FALSE(breaks_through(fillets(26, 14, right, 9), fillets(30, 15, right, 5)));
  EXPECT_FALSE(breaks_through(fillets(26, 14, right, 9), fillets(30, 15, right, 5), 0.9));
  EXPECT_TRUE(breaks_through(fillets(26, 14, kSlant, 9), fillets(30, 15, kSlant, 5)));
  const double steep = std::asin(0.75 * 1.01);
  EXPECT_FALSE(breaks_through(fillets(26, 14, steep, 9), fillets(30, 15, steep, 5)));
}

}  // namespace
}  // namespace dupin::canal
