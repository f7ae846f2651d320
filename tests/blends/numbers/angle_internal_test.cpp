#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "numbers/angle.h"

namespace dupin::numbers {
namespace {

TEST(AngleBetween, is_that_of_the_directions_whatever_their_lengths) {
  EXPECT_DOUBLE_EQ(angle_between(Vec3(2, 0, 0), Vec3(0, 0, 5)), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(angle_between(Vec3(1, 1, 0), Vec3(3, 0, 0)), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(angle_between(Vec3(1, 2, 3), Vec3(-2, -4, -6)), std::numbers::pi);
}

// Where the arc cosine of a rounded cosine would be 0.
TEST(AngleBetween, keeps_small_angles) {
  EXPECT_DOUBLE_EQ(angle_between(Vec3(1, 0, 0), Vec3(1, 1e-12, 0)), 1e-12);
}

}  // namespace
}  // namespace dupin::numbers
