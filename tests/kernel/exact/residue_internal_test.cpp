#include <array>
#include <cmath>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "exact/residue.h"

namespace dupin::exact {
namespace {

// By GMP alone: m 2^e modulo the prime, with a true inverse where e is negative.
Residue expected(const mpq_class& number) {
  const mpz_class prime = (mpz_class(1) << 61) - 1;
  mpz_class inverse, result;
  mpz_invert(inverse.get_mpz_t(), number.get_den_mpz_t(), prime.get_mpz_t());
  result = number.get_num() * inverse;
  mpz_fdiv_r(result.get_mpz_t(), result.get_mpz_t(), prime.get_mpz_t());
  return result.get_ui();
}

TEST(Residue, is_that_of_the_number) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-900, 900);
  for (int i = 0; i < 2000; ++i) {
    CGAL::Mpzf number(std::ldexp(mantissa(random), exponent(random)));
    for (int k = 0; k < i % 4; ++k) {
      const CGAL::Mpzf factor(std::ldexp(mantissa(random), exponent(random) / 8));
      number = number * factor + factor;
    }
    ASSERT_EQ(residue(number), expected(rational(number))) << i;
  }
  for (const double number : {0.0, 1.0, -1.0, 0.5, 0x1p61, 0x1p-61, 0x1p61 - 0x1p9, 5e-324}) {
    EXPECT_EQ(residue(CGAL::Mpzf(number)), expected(mpq_class(number))) << number;
  }
  EXPECT_EQ(residue(CGAL::Mpzf(0x1p61) - CGAL::Mpzf(1)), 0U);
  EXPECT_EQ(residue(CGAL::Mpzf(1) - CGAL::Mpzf(0x1p61)), 0U);
}

// Whatever weight homogeneous coordinates have, and none where the prime divides it.
TEST(Residue, is_one_of_a_point) {
  std::mt19937_64 random(62);
  std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
  for (int i = 0; i < 200; ++i) {
    std::array<CGAL::Mpzf, 4> point, scaled;
    const CGAL::Mpzf scale = CGAL::Mpzf(coordinate(random)) * CGAL::Mpzf(coordinate(random));
    for (std::size_t k = 0; k < 4; ++k) {
      point[k] = CGAL::Mpzf(coordinate(random)) * CGAL::Mpzf(coordinate(random));
      scaled[k] = point[k] * scale;
    }
    const auto residues_of_point = residues(point);
    ASSERT_TRUE(residues_of_point.has_value());
    EXPECT_EQ(residues(scaled), residues_of_point);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class value = rational(point[k]) / rational(point[3]);
      EXPECT_EQ((*residues_of_point)[k], expected(value));
    }
    point[i % 3] = point[i % 3] + CGAL::Mpzf(0x1p-80);
    EXPECT_NE(residues(point), residues_of_point);
    point[3] = CGAL::Mpzf(0x1p61) - CGAL::Mpzf(1);
    EXPECT_EQ(residues(point), std::nullopt);
  }
}

}  // namespace
}  // namespace dupin::exact
