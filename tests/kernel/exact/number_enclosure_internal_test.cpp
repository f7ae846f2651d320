#include <cmath>
#include <random>

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "exact/number_enclosure.h"

namespace dupin::exact {
namespace {

void expect_enclosed(const CGAL::Mpzf& number) {
  const mpq_class value = rational(number);
  const auto [low, high] = enclosure(number);
  EXPECT_TRUE(!std::isfinite(low) || mpq_class(low) <= value);
  EXPECT_TRUE(!std::isfinite(high) || mpq_class(high) >= value);
  EXPECT_LE(low, high);
  if (abs(value) > mpq_class(0x1p-1000) && abs(value) < mpq_class(0x1p1000)) {
    EXPECT_LE(high - low, 0x1p-51 * std::abs(high));
  }
}

// Products of small numbers leave what doubles hold. CGAL's conversion, where doubles are rounded
// upward, makes them too large then by a power of two.
TEST(NumberEnclosure, holds_numbers_of_any_size) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-400, 100);
  for (int round = 0; round < 2000; ++round) {
    CGAL::Mpzf number = 1;
    for (int factor = 0; factor < 1 + round % 5; ++factor) {
      number = number * CGAL::Mpzf(std::ldexp(mantissa(random), exponent(random)));
    }
    expect_enclosed(number);
    const CGAL::Protect_FPU_rounding<true> upward;
    expect_enclosed(number);
  }
  expect_enclosed(0);
}

}  // namespace
}  // namespace dupin::exact
