#include <random>

#include <CGAL/Interval_nt.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "mesh/exact_points.h"

namespace dupin::mesh {
namespace {

// Of every third place the coordinates, of the others a meeting of random points.
class MixedPoints : public testing::Test {
 protected:
  static bool is_meeting(std::size_t i) { return i % 3 != 1; }
  static LinePlaneMeeting meeting(std::size_t i) {
    std::mt19937_64 random(i);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    LinePlaneMeeting result;
    for (Vec3& point : result.of) {
      point = {coordinate(random), coordinate(random), coordinate(random)};
    }
    return result;
  }
  static ExactPoint coordinates(std::size_t i) {
    const auto n = static_cast<int>(i);
    return {n, n + 1, -n, 7};
  }
  static ExactPoint expected(std::size_t i) {
    return is_meeting(i) ? meeting(i).point() : coordinates(i);
  }
  static ExactPoints of(std::size_t count) { return {count, is_meeting, meeting, coordinates}; }
};

/// Whether the exact coordinates, of common denominator w, are in the balls, which are small.
void expect_enclosed(const ExactPoint& point) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const exact::BallPoint close = ball_point(point);
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class exact = exact::rational(point[k]) / exact::rational(point[3]);
    const mpq_class off = exact - mpq_class(close[k].high()) - mpq_class(close[k].low());
    ASSERT_LE(mpq_class(abs(off)), mpq_class(close[k].radius()));
    ASSERT_LE(mpq_class(close[k].radius()), mpq_class(abs(exact) * 0x1p-95 + 0x1p-900));
  }
}

TEST_F(MixedPoints, are_known_to_a_hundred_bits) {
  for (std::size_t i = 0; i < 100; ++i) {
    expect_enclosed(expected(i));
    // Homogeneous coordinates may be beyond doubles, and below, where points are not.
    ExactPoint large = expected(i), small = large;
    for (int k = 0; k < 4; ++k) {
      for (int times = 0; times < 3; ++times) {
        large[static_cast<std::size_t>(k)] =
            large[static_cast<std::size_t>(k)] * CGAL::Mpzf(0x1p500);
        small[static_cast<std::size_t>(k)] =
            small[static_cast<std::size_t>(k)] * CGAL::Mpzf(0x1p-500);
      }
    }
    expect_enclosed(large);
    expect_enclosed(small);
  }
}

TEST_F(MixedPoints, are_where_the_line_meets_the_plane) {
  for (std::size_t i = 0; i < 100; ++i) {
    const auto [x, y, z, w] = meeting(i).point();
    ASSERT_GT(exact::sign(w), 0);
    const auto [p, q, a, b, c] = meeting(i).of;
    // Times w, which is positive: in the plane, and on the line.
    const auto from = [&](const Vec3& origin) {
      return exact::ExactVector{x - CGAL::Mpzf(origin.x()) * w, y - CGAL::Mpzf(origin.y()) * w,
                                z - CGAL::Mpzf(origin.z()) * w};
    };
    const auto along = [](const Vec3& start, const Vec3& end) {
      return exact::exact_vector(end) - exact::exact_vector(start);
    };
    EXPECT_EQ(exact::sign(exact::dot(exact::cross(along(a, b), along(a, c)), from(a))), 0);
    for (const CGAL::Mpzf& component : exact::cross(along(p, q), from(p))) {
      EXPECT_EQ(exact::sign(component), 0);
    }
  }
}

TEST_F(MixedPoints, are_made_in_parallel_each_in_its_place) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{5}, 3 * support::Block::kSize + 2}) {
    const ExactPoints points = of(count);
    ASSERT_EQ(points.size(), count);
    EXPECT_EQ(points.empty(), count == 0);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(points.meeting(i) != nullptr, is_meeting(i));
      ASSERT_EQ(points[i], expected(i)) << i << " of " << count;
    }
  }
}

TEST_F(MixedPoints, stay_what_they_are_where_they_are_copied) {
  const ExactPoints some = of(10), more = of(7);
  ExactPoints all;
  all.push_back(coordinates(3));
  all.append(some);
  all.append(more);
  all.push_back(some, 1);
  all.push_back(some, 2);
  ASSERT_EQ(all.size(), 20U);
  EXPECT_EQ(all[0], coordinates(3));
  for (std::size_t i = 0; i < 17; ++i) {
    const std::size_t k = i < 10 ? i : i - 10;
    EXPECT_EQ(all[i + 1], expected(k)) << i;
    EXPECT_EQ(all.meeting(i + 1) != nullptr, is_meeting(k)) << i;
  }
  EXPECT_EQ(all[18], expected(1));
  EXPECT_EQ(all.meeting(18), nullptr);
  EXPECT_EQ(all[19], expected(2));
  EXPECT_NE(all.meeting(19), nullptr);
}

}  // namespace
}  // namespace dupin::mesh
