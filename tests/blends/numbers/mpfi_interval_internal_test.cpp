#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "numbers/mpfi_interval.h"

namespace dupin::numbers {
namespace {

using Narrow = MpfiInterval<128>;
using Wide = MpfiInterval<1024>;

// No double but the nearest lies inside.
void expect_rounded(const Enclosure& found, double nearest) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_LE(found.lower, nearest);
  EXPECT_GE(found.upper, nearest);
  EXPECT_GE(found.lower, std::nextafter(nearest, -kInfinity));
  EXPECT_LE(found.upper, std::nextafter(nearest, kInfinity));
}

TEST(MpfiInterval, functions_are_those_of_the_c_library_to_the_last_bit) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> number(-3, 3);
  for (int i = 0; i < 300; ++i) {
    const double x = number(random), y = number(random);
    const auto near = [](const Narrow& found, double expected) {
      const Enclosure e = found.rounded_outward();
      EXPECT_NEAR(e.lower, expected, 4e-16 * (1 + std::abs(expected)));
      EXPECT_NEAR(e.upper, expected, 4e-16 * (1 + std::abs(expected)));
      EXPECT_LT(e.lower, e.upper);  // no result of these is a double
    };
    near(cosine(Narrow(x)), std::cos(x));
    near(sine(Narrow(x)), std::sin(x));
    near(angle(Narrow(y), Narrow(x)), std::atan2(y, x));
    near(square_root(Narrow(std::abs(x))), std::sqrt(std::abs(x)));
    near(Narrow(x) / y, x / y);
  }
}

TEST(MpfiInterval, results_hold_the_exact_ones) {
  const mpq_class third(1, 3), seventh(1, 7);
  const Narrow a(third), b(seventh);
  const auto difference = [](const Narrow& found, const mpq_class& exact) {
    return (found - Narrow(exact)).rounded_outward();
  };
  for (const Enclosure& e : {difference(a + b, third + seventh), difference(a - b, third - seventh),
                             difference(a * b, third * seventh), difference(a / b, third / seventh),
                             difference(square(a), third * third)}) {
    EXPECT_LE(e.lower, 0);
    EXPECT_GE(e.upper, 0);
    EXPECT_LT(e.upper - e.lower, 1e-37);
  }
}

TEST(MpfiInterval, identities_hold_to_the_bits_asked_for) {
  const Wide x(0.7);
  const Enclosure one = (square(cosine(x)) + square(sine(x)) - 1).rounded_outward();
  EXPECT_LE(one.lower, 0);
  EXPECT_GE(one.upper, 0);
  EXPECT_LT(one.upper - one.lower, 1e-300);
  expect_rounded(Wide::pi().rounded_outward(), std::numbers::pi);
  expect_rounded(cosine(Wide::pi() / 3).rounded_outward(), .5);
}

TEST(MpfiInterval, products_of_four_doubles_are_exact) {
  const double a = 1 + std::ldexp(1, -52), b = 1 - std::ldexp(1, -53);
  const Enclosure zero = (Wide(a) * b * a * b - square(Wide(a) * b)).rounded_outward();
  EXPECT_EQ(zero.lower, 0);
  EXPECT_EQ(zero.upper, 0);
}

TEST(MpfiInterval, ends_are_rounded_outward_and_zeros_have_no_sign) {
  const Enclosure third = Narrow(mpq_class(1, 3)).rounded_outward();
  EXPECT_LT(mpq_class(third.lower), mpq_class(1, 3));
  EXPECT_GT(mpq_class(third.upper), mpq_class(1, 3));
  EXPECT_FALSE(std::signbit((Narrow(0) * -1).rounded_outward().upper));
  const Enclosure between = Narrow::between(-1, 2).rounded_outward();
  EXPECT_EQ(between.lower, -1);
  EXPECT_EQ(between.upper, 2);
  EXPECT_EQ(magnitude(Narrow::between(-1, 2)).rounded_outward().upper, 2);
  EXPECT_EQ(square(Narrow::between(-1, 2)).rounded_outward().lower, 0);
}

TEST(MpfiInterval, is_positive_where_all_of_it_is) {
  EXPECT_TRUE(Narrow::between(1e-300, 1).is_positive());
  EXPECT_FALSE(Narrow::between(0, 1).is_positive());
  EXPECT_FALSE(Narrow::between(-1, 1).is_positive());
}

TEST(MpfiInterval, without_a_result_is_the_whole_line) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Narrow none = std::nan(""), whole = Narrow::between(-kInfinity, kInfinity);
  for (const Narrow& x :
       {none, Narrow::between(2, 1), square_root(Narrow(-1)), Narrow(0) / 0, whole * 0 + whole,
        cosine(none) * whole, angle(none, none) * whole, whole - whole, none + 1}) {
    EXPECT_EQ(x.rounded_outward().lower, -kInfinity);
    EXPECT_EQ(x.rounded_outward().upper, kInfinity);
    EXPECT_FALSE(x.is_positive());
  }
}

TEST(MpfiInterval, is_copied_by_value) {
  Narrow a = 1;
  Narrow b = a;
  b = b + 1;
  EXPECT_EQ(a.rounded_outward().upper, 1);
  a = b;
  EXPECT_EQ(a.rounded_outward().lower, 2);
}

}  // namespace
}  // namespace dupin::numbers
