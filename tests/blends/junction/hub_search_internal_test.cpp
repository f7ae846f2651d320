#include <gtest/gtest.h>

#include "junction/hub_search.h"

namespace dupin::junction {
namespace {

Vec3 nearest(const std::vector<Ring>& ends) { return nearest_to_axes(approaches_of(ends)); }

TEST(NearestToAxes, is_where_they_meet) {
  const Vec3 place(1, 2, 3), one = Vec3(1, 2, 2) / 3, other = Vec3(0, 0.6, -0.8);
  EXPECT_LT((nearest({{place - 4 * one, one, 1}, {place - 7 * other, other, 2}}) - place).norm(),
            1e-13);
}

TEST(NearestToAxes, of_pipes_that_face_each_other_is_in_the_middle) {
  const Vec3 x = Vec3::UnitX();
  EXPECT_LT((nearest({{Vec3(-3, 1, 1), x, 1}, {Vec3(5, 1, 1), -x, 1}}) - Vec3(1, 1, 1)).norm(),
            1e-13);
  // All but facing each other, the axes meet far away.
  const Vec3 bent = Vec3(-1, 0.01, 0).normalized();
  EXPECT_LT((nearest({{Vec3(-3, 0, 0), x, 1}, {Vec3(3, 0.01, 0), bent, 1}})).norm(), 0.02);
}

TEST(ArmsTo, begin_at_the_ends_after_straight_pieces) {
  const Vec3 x = Vec3::UnitX();
  const std::vector<Ring> ends{{Vec3(-9, 0, 0), x, 1}, {Vec3(3, 0, 0), -x, 1}};
  const std::vector<double> ways{5, 0};
  const Junction junction = arms_to({Vec3(0, 0, 0), 1.5}, approaches_of(ends), ways);
  ASSERT_EQ(junction.arms.size(), 2U);
  EXPECT_EQ(junction.arms[0].end, ends[0]);
  EXPECT_EQ(junction.arms[0].collar.start(), (PeVector{Vec3(-4, 0, 0), 1}));
  EXPECT_EQ(straight_length(junction.arms[0]), 5);
  EXPECT_FALSE(junction.arms[1].straight.has_value());
  EXPECT_EQ(junction.arms[1].collar.start(), (PeVector{Vec3(3, 0, 0), 1}));
}

}  // namespace
}  // namespace dupin::junction
