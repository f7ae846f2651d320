#include <gtest/gtest.h>

#include "tessellation/plane_segments.h"

namespace dupin::tessellation {
namespace {

TEST(PlaneSegments, cross_inside_of_both_only) {
  const Vec2 a(0, 0), b(4, 0);
  EXPECT_TRUE(cross_inside(a, b, {1, -1}, {1, 1}));
  EXPECT_TRUE(cross_inside({1, 1}, {1, -1}, b, a)) << "in any order";
  EXPECT_FALSE(cross_inside(a, b, {1, 0}, {1, 1})) << "one ends on the other";
  EXPECT_FALSE(cross_inside(a, b, {1, 1}, {1, 2})) << "one ends before";
  EXPECT_FALSE(cross_inside(a, b, {5, -1}, {5, 1})) << "one passes beside";
  EXPECT_FALSE(cross_inside(a, b, {1, 0}, {3, 0})) << "one line";
}

TEST(PlaneSegments, cross_is_positive_to_the_left) {
  EXPECT_EQ(cross({2, 0}, {5, 3}), 6);
  EXPECT_EQ(cross({5, 3}, {2, 0}), -6);
}

}  // namespace
}  // namespace dupin::tessellation
