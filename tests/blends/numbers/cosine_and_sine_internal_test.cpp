#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "numbers/cosine_and_sine.h"
#include "numbers/mpfi_interval.h"

namespace dupin::numbers {
namespace {

using Wide = MpfiInterval<128>;

constexpr double kPi = std::numbers::pi;

// Holds what MPFI finds with twice as many bits, and is a few doubles wider at most, or as much as
// the difference from a multiple of pi/2 is.
void expect_tight(const Interval& found, const Wide& expected, const Interval& x) {
  const auto [lower, upper] = expected.rounded_outward();
  EXPECT_LE(found.lower, lower) << x.lower << ' ' << x.upper;
  EXPECT_GE(found.upper, upper) << x.lower << ' ' << x.upper;
  constexpr double kFew = 0x1p-48, kLeast = 1e-24;
  EXPECT_GE(found.lower, lower - kFew * std::abs(lower) - kLeast) << x.lower << ' ' << x.upper;
  EXPECT_LE(found.upper, upper + kFew * std::abs(upper) + kLeast) << x.lower << ' ' << x.upper;
}

void compare(const Interval& x) {
  const Wide wide = Wide::between(x.lower, x.upper), two(2.0);
  const auto [c, s] = cosine_and_sine(x);
  expect_tight(c, cosine(wide), x);
  expect_tight(s, sine(wide), x);
  const Wide half = (wide - Wide::pi() / two) / two;
  const auto [p, q] = cosine_and_sine_of_half_beyond_quarter(x);
  expect_tight(p, cosine(half), x);
  expect_tight(q, sine(half), x);
}

TEST(CosineAndSine, are_those_of_mpfi_on_intervals_of_all_widths) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-7, 7), exponent(-60, 2);
  for (int i = 0; i < 2000; ++i) {
    const double from = place(random);
    compare({from, from + std::exp2(exponent(random))});
  }
}

TEST(CosineAndSine, are_those_of_mpfi_at_the_extremes_and_zeros) {
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const double at = quarter * kPi / 2;
    for (const double width : {0.0, 1e-15, 1e-9, 0.5, 1.6}) {
      compare({at, at + width});
      compare({at - width, at});
      compare({next_below(at - width), next_above(at + width)});
    }
  }
  compare({0, 0});
}

// The sine is less than a small angle, by less than any double tells, and the cosine less than 1.
TEST(CosineAndSine, hold_numbers_that_no_double_is) {
  for (const double x : {1e-300, 1e-20, 1e-9}) {
    const auto [c, s] = cosine_and_sine({x, x});
    EXPECT_LT(s.lower, x);
    EXPECT_GE(s.upper, x);
    EXPECT_LT(c.lower, 1);
    EXPECT_EQ(c.upper, 1);
  }
}

TEST(CosineAndSine, of_what_is_too_large_is_all_there_is) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Interval& x : {Interval(0, 1e9), Interval::whole(), Interval(-kInfinity, 0)}) {
    const auto [c, s] = cosine_and_sine(x);
    EXPECT_EQ(c.lower, -1);
    EXPECT_EQ(s.upper, 1);
  }
}

}  // namespace
}  // namespace dupin::numbers
