#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "tessellation/face_strip.h"

namespace dupin::tessellation {
namespace {

constexpr double kAround = 24;

struct Face {
  std::vector<Vec2> places;

  UnrolledCurve curve(int corners, const auto& place) {
    std::vector<std::uint32_t> own;
    for (int i = 0; i < corners; ++i) {
      own.push_back(std::uint32_t(places.size()));
      places.push_back(place(i));
    }
    return unrolled(own, places, kAround);
  }
  UnrolledCurve ring(double y, double x) {
    return curve(int(kAround), [&](int i) { return Vec2(std::remainder(x + i, kAround), y); });
  }
  UnrolledCurve circle(double x, double y, double radius) {
    return curve(20, [&](int i) {
      const double t = 2 * std::numbers::pi * i / 20;
      return Vec2(std::remainder(x + radius * std::cos(t), kAround), y + radius * std::sin(t));
    });
  }
  // Of a triangle whose corners are less than half a turn apart, counter-clockwise ones positive.
  [[nodiscard]] double area(const Triangle& t) const {
    Vec2 ab = places[t[1]] - places[t[0]], ac = places[t[2]] - places[t[0]];
    ab.x() = std::remainder(ab.x(), kAround);
    ac.x() = std::remainder(ac.x(), kAround);
    return (ab.x() * ac.y() - ab.y() * ac.x()) / 2;
  }
};

// The triangles of a strip; no side of two of them runs the same way.
struct Filling {
  Filling(FaceStrip& strip, Face& face) {
    std::vector<Triangle> triangles;
    strip.append_triangles(triangles, [&](const Vec2& place) {
      face.places.push_back(place);
      return std::uint32_t(face.places.size() - 1);
    });
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const Triangle& t : triangles) {
      least_area = std::min(least_area, face.area(t));
      area += face.area(t);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(sides.insert({t[i], t[(i + 1) % 3]}).second);
      }
    }
    open_sides = std::ranges::count_if(sides, [&](const auto& side) {
      return !sides.contains({side.second, side.first});
    });
  }
  double area = 0, least_area = std::numeric_limits<double>::infinity();
  std::ptrdiff_t open_sides = 0;  // of one triangle alone
};

TEST(FaceStrip, is_filled_around_its_holes) {
  for (const double x : {0.0, 5.3, 11.9}) {
    Face face;
    const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(8, 0.3),
                        hole = face.circle(x, 4, 2), other = face.circle(x + 9, 9, 0.5);
    FaceStrip strip(lower, upper, kAround);
    EXPECT_TRUE(strip.contains(hole));
    EXPECT_FALSE(strip.contains(other));
    strip.add(hole);
    const Filling filling(strip, face);
    EXPECT_GT(filling.least_area, 0);
    EXPECT_NEAR(filling.area, 8 * kAround - 10 * 4 * std::sin(std::numbers::pi / 10), 1e-9);
    EXPECT_EQ(filling.open_sides, 24 + 24 + 20) << "the cut is closed";
  }
}

// Zigzags about the axis with narrow ways past them that no straight line passes, at any place.
TEST(FaceStrip, is_cut_through_holes_that_leave_no_straight_way) {
  for (const double gap : {1.5, 0.3, 0.02}) {
    for (const double x : {0.0, 3.7, 11.9}) {
      Face face;
      const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(16, 0.3);
      // Long rhombi, each but for the gap as wide as a turn, in three rows.
      std::vector<UnrolledCurve> holes;
      for (int row = 0; row < 3; ++row) {
        const double left = x + 5 * row, width = kAround - gap;
        holes.push_back(face.curve(80, [&](int i) {
          const double share = i < 40 ? i / 40. : 2 - i / 40.;
          const double y = (i < 40 ? -1 : 1) * (0.5 - std::abs(share - 0.5));
          return Vec2(std::remainder(left + share * width, kAround), 4 + 4 * row + y);
        }));
      }
      FaceStrip strip(lower, upper, kAround);
      double area = 16 * kAround;
      for (const UnrolledCurve& hole : holes) {
        EXPECT_TRUE(strip.contains(hole));
        strip.add(hole);
        area -= (kAround - gap) / 2;
      }
      const Filling filling(strip, face);
      EXPECT_NEAR(filling.area, area, 1e-9);
      EXPECT_EQ(filling.open_sides, 24 + 24 + 3 * 80) << "the cut is closed";
    }
  }
}

// Rings begin anywhere, and a hole may begin at the x of one of their corners, or a bit beside it,
// on either side of the place where x jumps by a turn: each side is met once.
TEST(FaceStrip, contains_holes_that_begin_over_a_corner_of_its_curves) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> phase(-kAround, kAround);
  int tried = 0;
  for (int round = 0; round < 200; ++round) {
    Face face;
    const UnrolledCurve lower = face.ring(0, phase(random)), upper = face.ring(8, phase(random));
    const FaceStrip strip(lower, upper, kAround);
    for (const UnrolledCurve* ring : {&lower, &upper}) {
      for (const Vec2& corner : ring->places) {
        for (const double turns : {-1.0, 0.0, 1.0}) {
          const double at = corner.x() + turns * kAround;
          for (const double x : {std::nextafter(at, -1e9), at, std::nextafter(at, 1e9)}) {
            const auto hole = [&](double y) {
              return UnrolledCurve{{1000, 1001, 1002}, {{x, y}, {x + 1, y}, {x, y + 1}}};
            };
            ASSERT_TRUE(strip.contains(hole(4))) << testing::PrintToString(x);
            ASSERT_FALSE(strip.contains(hole(-4)));
            ASSERT_FALSE(strip.contains(hole(12)));
            ++tried;
          }
        }
      }
    }
  }
  EXPECT_GT(tried, 50000);
}

// That corner is neither above nor below the curve.
TEST(FaceStrip, contains_a_hole_that_begins_where_it_touches_a_curve) {
  Face face;
  const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(8, 0.3);
  const FaceStrip strip(lower, upper, kAround);
  for (std::size_t i = 0; i < lower.places.size(); ++i) {
    const Vec2& at = lower.places[i];
    EXPECT_TRUE(
        strip.contains({{lower.corners[i], 1001, 1002}, {at, at + Vec2(1, 1), at + Vec2(0, 1)}}));
    EXPECT_FALSE(
        strip.contains({{lower.corners[i], 1001, 1002}, {at, at - Vec2(1, 1), at - Vec2(0, 1)}}));
  }
}

TEST(FaceStrip, refuses_curves_that_cross) {
  Face face;
  const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(4, 0), hole = face.circle(3, 3, 2);
  FaceStrip strip(lower, upper, kAround);
  strip.add(hole);
  std::vector<Triangle> triangles;
  EXPECT_THROW(strip.append_triangles(triangles, [](const Vec2&) { return 0U; }), Error);
}

TEST(AppendBand, joins_rings_that_are_turned_against_each_other) {
  for (const double turn : {0.0, 0.4, -0.4, 7.2}) {
    Face face;
    const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(2, turn);
    std::vector<Triangle> triangles;
    append_band(lower, upper, kAround, triangles);
    ASSERT_EQ(triangles.size(), 48U);
    double sum = 0;
    for (const Triangle& t : triangles) {
      EXPECT_GT(face.area(t), 0);
      sum += face.area(t);
    }
    EXPECT_NEAR(sum, 2 * kAround, 1e-12);
  }
}

}  // namespace
}  // namespace dupin::tessellation
