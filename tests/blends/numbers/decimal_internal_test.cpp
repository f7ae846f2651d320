#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "numbers/decimal.h"

namespace dupin::numbers {
namespace {

TEST(Decimal, reads_back_as_the_same_double) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    EXPECT_EQ(std::stod(decimal(x)), x);
  }
}

TEST(Decimal, is_as_short_as_can_be) {
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(decimal(-20), "-20");
  EXPECT_EQ(decimal(1e300), "1e+300");
  EXPECT_EQ(decimal(0.1 + 0.2), "0.30000000000000004");
}

TEST(Decimal, has_the_digits_asked_for) {
  EXPECT_EQ(decimal(2. / 3, 3), "0.667");
  EXPECT_EQ(decimal(1234.5678, 2), "1.2e+03");
  EXPECT_EQ(decimal(0.5, 6), "0.5");
}

}  // namespace
}  // namespace dupin::numbers
