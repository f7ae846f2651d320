#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tessellation/touching_holes.h"

namespace dupin::tessellation {
namespace {

constexpr double kAround = 40;

// Rhombi about the axis, of so many corners on each side; places of equal x, a turn apart, and y
// have one corner.
class Face {
 public:
  UnrolledCurve rhombus(double left, double right, double y, int sides = 4) {
    const Vec2 corners[] = {
        {left, y}, {(left + right) / 2, y - 3}, {right, y}, {(left + right) / 2, y + 3}};
    std::vector<std::uint32_t> polygon;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < sides; ++k) {
        const double share = double(k) / sides;
        polygon.push_back(corner((1 - share) * corners[i] + share * corners[(i + 1) % 4]));
      }
    }
    return unrolled(polygon, places, kAround);
  }

  std::vector<Vec2> places;

 private:
  std::uint32_t corner(Vec2 place) {
    place.x() = std::remainder(place.x(), kAround);
    const auto known =
        std::ranges::find_if(places, [&](const Vec2& p) { return (p - place).norm() < 1e-9; });
    if (known == places.end()) {
      places.push_back(place);
      return std::uint32_t(places.size() - 1);
    }
    return std::uint32_t(known - places.begin());
  }
};

// Without direction.
std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides(
    const std::vector<UnrolledCurve>& curves) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const UnrolledCurve& curve : curves) {
    for (std::size_t i = 0; i < curve.corners.size(); ++i) {
      result.insert(std::minmax(curve.corners[i], curve.corners[(i + 1) % curve.corners.size()]));
    }
  }
  return result;
}

TEST(TouchingHoles, become_two_curves_about_the_axis) {
  Face face;
  const std::vector<UnrolledCurve> holes{face.rhombus(-8, 12, 5), face.rhombus(12, 32, 5)};
  const auto linked = linked_about(holes, face.places, kAround);
  ASSERT_EQ(linked.size(), 2U);
  for (const UnrolledCurve& curve : linked) {
    EXPECT_EQ(curve.turns, 1);
    EXPECT_EQ(curve.corners.size(), 16U);
  }
  EXPECT_EQ(std::min(linked[0].low, linked[1].low), 2);
  EXPECT_EQ(std::max(linked[0].low, linked[1].low), 5) << "one is above the other";
  EXPECT_EQ(sides(linked), sides(holes));
}

TEST(TouchingHoles, are_bridged_where_they_all_but_meet) {
  Face face;
  std::vector<UnrolledCurve> holes{face.rhombus(-8, 12, 5), face.rhombus(12.01, 31.5, 5)};
  auto linked = linked_about(holes, face.places, kAround);
  ASSERT_EQ(linked.size(), 2U);
  for (const UnrolledCurve& curve : linked) {
    EXPECT_EQ(curve.turns, 1);
    EXPECT_EQ(curve.corners.size(), 18U) << "half of each hole, and two sides across";
  }
  EXPECT_EQ(sides(linked).size(), sides(holes).size() + 4) << "these are there twice";
  // One hole about the whole axis, with another one beside it.
  Face other;
  holes = {other.rhombus(-19.8, 19.9, 5), other.rhombus(0, 3, 20)};
  linked = linked_about(holes, other.places, kAround);
  ASSERT_EQ(linked.size(), 3U);
  EXPECT_EQ(std::ranges::count(linked, 0, &UnrolledCurve::turns), 1);
}

// Wherever about the axis the hole is: where its ends are is rounded.
TEST(TouchingHoles, are_bridged_to_themselves_at_any_place) {
  for (int i = 0; i < 100; ++i) {
    Face face;
    const double left = -20 + .377 * i;
    const std::vector<UnrolledCurve> holes{face.rhombus(left, left + 39.99, 5)};
    const auto linked = linked_about(holes, face.places, kAround);
    ASSERT_EQ(linked.size(), 2U) << left;
    EXPECT_EQ(linked[0].turns, 1);
  }
}

// Those of a branch near a cross are no part of it, however near they are along the axis.
TEST(TouchingHoles, are_not_bridged_to_others_beside_them) {
  for (const double gap : {0.0, 0.3}) {
    for (const double x : {-6., 2., 12., 22.}) {
      for (const double y : {-2., 12.}) {
        Face face;
        const std::vector<UnrolledCurve> holes{face.rhombus(x, x + 6, y), face.rhombus(-8, 12, 5),
                                               face.rhombus(12 + gap, 32, 5),
                                               face.rhombus(x + 5, x + 8, y + (y < 0 ? -7 : 7))};
        const auto linked = linked_about(holes, face.places, kAround);
        ASSERT_EQ(linked.size(), 4U) << x << ' ' << y;
        EXPECT_EQ(std::ranges::count(linked, 1, &UnrolledCurve::turns), 2);
        EXPECT_EQ(
            std::ranges::count(linked, 16U, [](const auto& curve) { return curve.corners.size(); }),
            gap == 0 ? 4 : 2);
        EXPECT_EQ(sides(linked).size(), sides(holes).size() + (gap == 0 ? 0 : 2));
      }
    }
  }
}

// Two crosses on one run, each with gaps of its own.
TEST(TouchingHoles, are_bridged_in_chains_by_themselves) {
  Face face;
  const std::vector<UnrolledCurve> holes{face.rhombus(-8, 12, 5), face.rhombus(-2, 17.5, 12),
                                         face.rhombus(12.01, 31.5, 5), face.rhombus(18, 37.7, 12)};
  const auto linked = linked_about(holes, face.places, kAround);
  ASSERT_EQ(linked.size(), 4U);
  EXPECT_EQ(std::ranges::count(linked, 1, &UnrolledCurve::turns), 4);
  EXPECT_EQ(sides(linked).size(), sides(holes).size() + 8);
}

TEST(TouchingHoles, stay_where_there_is_a_way_past_them) {
  Face face;
  const std::vector<UnrolledCurve> holes{face.rhombus(-8, 12, 5), face.rhombus(12, 29, 5),
                                         face.rhombus(0, 4, 8.5)};
  const auto same = linked_about(holes, face.places, kAround);
  ASSERT_EQ(same.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(same[i].corners, holes[i].corners);
  }
}

}  // namespace
}  // namespace dupin::tessellation
