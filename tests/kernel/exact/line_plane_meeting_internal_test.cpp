#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "exact/line_plane_meeting.h"

namespace dupin::exact {
namespace {

using Point = std::array<CGAL::Mpzf, 4>;

CGAL::Mpzf determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const ExactVector origin = exact_vector(a);
  return dot(cross(exact_vector(b) - origin, exact_vector(c) - origin), exact_vector(p) - origin);
}

/// The same by numbers of any size.
Point meeting(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const CGAL::Mpzf alpha = determinant(a, b, c, p), beta = determinant(a, b, c, q);
  Point point;
  for (int k = 0; k < 3; ++k) {
    point[static_cast<std::size_t>(k)] = CGAL::Mpzf(p[k]) * beta - CGAL::Mpzf(q[k]) * alpha;
  }
  point[3] = beta - alpha;
  if (sign(point[3]) < 0) {
    for (CGAL::Mpzf& x : point) {
      x = -x;
    }
  }
  return point;
}

// Of up to `bits` bits, and units far apart.
TEST(LatticeMeeting, is_what_longer_numbers_give) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 20000; ++round) {
    const int bits = 1 + round % 53;
    std::uniform_int_distribution<std::int64_t> steps(-(std::int64_t{1} << bits) + 1,
                                                      (std::int64_t{1} << bits) - 1);
    std::uniform_int_distribution<int> exponent(-140, 140);
    const std::array<int, 3> units{exponent(random), exponent(random), exponent(random)};
    std::array<Vec3, 5> x;
    for (Vec3& point : x) {
      for (int k = 0; k < 3; ++k) {
        point[k] =
            std::ldexp(static_cast<double>(steps(random)), units[static_cast<std::size_t>(k)]);
      }
    }
    if (round % 5 == 0) {
      x[1] = x[0];  // no line
    }
    const auto found = lattice_meeting(x[0], x[1], x[2], x[3], x[4]);
    ASSERT_TRUE(found) << round;
    ASSERT_EQ(*found, meeting(x[0], x[1], x[2], x[3], x[4])) << round;
    ASSERT_EQ(line_plane_meeting(x[0], x[1], x[2], x[3], x[4]), *found) << round;
  }
}

// All bits that steps, differences, products and sums may have.
TEST(LatticeMeeting, does_not_overflow) {
  const double most = 0x1p60 - 0x1p7, odd = 0x1p8 + 1;
  for (int pattern = 0; pattern < 1 << 15; ++pattern) {
    std::array<Vec3, 5> x;
    for (int i = 0; i < 15; ++i) {
      const double size = i % 7 == 6 ? odd : most;
      x[static_cast<std::size_t>(i / 3)][i % 3] = (pattern >> i & 1) != 0 ? size : -size;
    }
    const auto found = lattice_meeting(x[0], x[1], x[2], x[3], x[4]);
    ASSERT_TRUE(found) << pattern;
    ASSERT_EQ(*found, meeting(x[0], x[1], x[2], x[3], x[4])) << pattern;
  }
}

TEST(LatticeMeeting, is_left_to_longer_numbers_where_bits_are_too_far_apart) {
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), far(2, 3, 5);
  EXPECT_TRUE(lattice_meeting(Vec3::Zero(), far, x, y, z));
  EXPECT_TRUE(lattice_meeting(Vec3(0x1p-58, 0, 0), far, x, y, z));
  EXPECT_FALSE(lattice_meeting(Vec3(0x1p-60, 0, 0), far, x, y, z));
  EXPECT_FALSE(lattice_meeting(0x1p300 * x, 0x1p300 * far, 0x1p300 * x, 0x1p300 * y, 0x1p300 * z));
}

TEST(LinePlaneMeeting, is_of_any_coordinates) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-1000, 900);
  int longer = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<Vec3, 5> x;
    for (Vec3& point : x) {
      for (double& coordinate : point) {
        coordinate = std::ldexp(mantissa(random), exponent(random));
      }
    }
    longer += lattice_meeting(x[0], x[1], x[2], x[3], x[4]) ? 0 : 1;
    ASSERT_EQ(line_plane_meeting(x[0], x[1], x[2], x[3], x[4]),
              meeting(x[0], x[1], x[2], x[3], x[4]))
        << round;
  }
  EXPECT_GT(longer, 1900);
}

}  // namespace
}  // namespace dupin::exact
