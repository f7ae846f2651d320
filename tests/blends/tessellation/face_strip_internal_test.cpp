#include <cmath>
#include <numbers>
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

TEST(FaceStrip, is_filled_around_its_holes) {
  for (const double x : {0.0, 5.3, 11.9}) {
    Face face;
    const UnrolledCurve lower = face.ring(0, 0), upper = face.ring(8, 0.3),
                        hole = face.circle(x, 4, 2), other = face.circle(x + 9, 9, 0.5);
    FaceStrip strip(lower, upper, kAround);
    EXPECT_TRUE(strip.contains(hole));
    EXPECT_FALSE(strip.contains(other));
    strip.add(hole);
    std::vector<Triangle> triangles;
    strip.append_triangles(triangles, [&](const Vec2& place) {
      face.places.push_back(place);
      return std::uint32_t(face.places.size() - 1);
    });
    double sum = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const Triangle& t : triangles) {
      EXPECT_GT(face.area(t), 0);
      sum += face.area(t);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(sides.insert({t[i], t[(i + 1) % 3]}).second);
      }
    }
    EXPECT_NEAR(sum, 8 * kAround - 10 * 4 * std::sin(std::numbers::pi / 10), 1e-9);
    EXPECT_EQ(std::ranges::count_if(sides,
                                    [&](const auto& s) {
                                      return !sides.contains({s.second, s.first});
                                    }),
              24 + 24 + 20)
        << "the cut is closed";
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
