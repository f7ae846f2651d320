#include <cmath>
#include <limits>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "predicates/lattice_orientation.h"

namespace dupin::predicates {
namespace {

int by_rationals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  mpq_class d[3][3];
  for (int k = 0; k < 3; ++k) {
    d[k][0] = mpq_class(b[k]) - mpq_class(a[k]);
    d[k][1] = mpq_class(c[k]) - mpq_class(a[k]);
    d[k][2] = mpq_class(p[k]) - mpq_class(a[k]);
  }
  mpq_class sum = 0;
  for (int k = 0; k < 3; ++k) {
    const auto &u = d[(k + 1) % 3], &v = d[(k + 2) % 3];
    sum += (u[0] * v[1] - u[1] * v[0]) * d[k][2];
  }
  return sgn(sum);
}

// Numbers of up to `bits` bits in units of each axis' own.
class Numbers {
 public:
  Vec3 point(int bits) {
    std::uniform_int_distribution<std::int64_t> steps(-(std::int64_t{1} << bits),
                                                      std::int64_t{1} << bits);
    Vec3 result;
    for (int k = 0; k < 3; ++k) {
      result[k] = std::ldexp(static_cast<double>(steps(random_)), units_[k]);
    }
    return result;
  }
  Vec3 in_plane_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    std::uniform_int_distribution<int> factor(-3, 3);
    return a + factor(random_) * (b - a) + factor(random_) * (c - a);  // exact for few bits
  }
  void take_units(int least, int most) {
    for (int& unit : units_) {
      unit = std::uniform_int_distribution<int>(least, most)(random_);
    }
  }

 private:
  std::mt19937 random_{7};
  int units_[3] = {0, 0, 0};
};

TEST(LatticeOrientation, is_the_sign_by_rationals) {
  Numbers numbers;
  int signs[3] = {0, 0, 0};
  for (int round = 0; round < 20000; ++round) {
    numbers.take_units(-300, 300);
    const int bits = round % 53;
    const Vec3 a = numbers.point(bits), b = numbers.point(bits), c = numbers.point(bits);
    const Vec3 p = round % 3 == 0 ? numbers.point(bits) : numbers.in_plane_of(a, b, c);
    const auto sign = lattice_orientation(a, b, c, p);
    ASSERT_TRUE(sign) << round;
    ASSERT_EQ(*sign, by_rationals(a, b, c, p)) << round;
    ++signs[*sign + 1];
  }
  for (const int count : signs) {
    EXPECT_GT(count, 1000);
  }
}

// All bits that differences, minors and sums may have.
TEST(LatticeOrientation, does_not_overflow) {
  const double most = 0x1p60 - 0x1p7, odd = 0x1p8 + 1;  // 60 bits between them
  int decided = 0;
  for (int pattern = 0; pattern < 1 << 12; ++pattern) {
    Vec3 points[4];
    for (int i = 0; i < 12; ++i) {
      const double size = i % 5 == 4 ? odd : most;
      points[i / 3][i % 3] = (pattern >> i & 1) != 0 ? size : -size;
    }
    const auto sign = lattice_orientation(points[0], points[1], points[2], points[3]);
    ASSERT_TRUE(sign);
    ASSERT_EQ(*sign, by_rationals(points[0], points[1], points[2], points[3])) << pattern;
    decided += *sign != 0 ? 1 : 0;
  }
  EXPECT_GT(decided, 1000);
}

TEST(LatticeOrientation, is_left_to_others_where_bits_are_too_far_apart) {
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(lattice_orientation(Vec3::Zero(), x, y, z), 1);
  EXPECT_EQ(lattice_orientation(Vec3::Zero(), y, x, z), -1);
  EXPECT_EQ(lattice_orientation(Vec3::Zero(), x, y, x + y), 0);
  EXPECT_EQ(lattice_orientation(Vec3(0x1p-59, 0, 0), x, y, z), 1);
  EXPECT_EQ(lattice_orientation(Vec3(0x1p-60, 0, 0), x, y, z), std::nullopt);
  EXPECT_EQ(lattice_orientation(Vec3(0x1p900, 0, 0), x, y, z), std::nullopt);
  EXPECT_EQ(lattice_orientation(Vec3(0x1p900, 0, 0), x, y, -x), 0) << "in a plane across an axis";
}

TEST(LatticeOrientation, is_told_or_left_at_the_ends_of_the_range) {
  for (const double size : {std::numeric_limits<double>::denorm_min(), 0x1p-1022, 0x1p-1000,
                            0x1p-60, 0x1p1000, 0x1p1023, std::numeric_limits<double>::max()}) {
    const Vec3 x(size, 0, 0), y(0, size, 0), z(0, 0, size);
    const auto sign = lattice_orientation(Vec3::Zero(), x, y, z);
    EXPECT_TRUE(!sign || *sign == 1) << size;
  }
}

}  // namespace
}  // namespace dupin::predicates
