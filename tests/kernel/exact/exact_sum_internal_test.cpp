#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "exact/exact_sum.h"

namespace dupin::exact {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max(),
                 kSmallest = std::numeric_limits<double>::denorm_min();

using Factors = std::array<double, 3>;

mpq_class rational_sum(const std::vector<Factors>& products) {
  mpq_class sum = 0;
  for (const auto& [a, b, c] : products) {
    sum += mpq_class(a) * mpq_class(b) * mpq_class(c);
  }
  return sum;
}

mpq_class exact_sum(const std::vector<Factors>& products) {
  ExactSum sum;
  for (const auto& [a, b, c] : products) {
    sum.add_product(a, b, c);
  }
  return sum.value();
}

TEST(ExactSum, equals_the_sum_of_rationals) {
  std::mt19937_64 random(11);
  const auto any = [&] {
    return std::ldexp(static_cast<double>(random() >> 11) - 0x1p52,
                      static_cast<int>(random() % 600) - 400);
  };
  ExactSum sum;
  mpq_class expected;
  for (int i = 0; i < 3000; ++i) {
    const double a = any(), b = any(), c = any();
    sum.add_product(a, b, c);
    expected += mpq_class(a) * mpq_class(b) * mpq_class(c);
  }
  EXPECT_EQ(sum.value(), expected);
}

TEST(ExactSum, holds_the_extremes) {
  ExactSum sum;
  mpq_class expected;
  for (const double sign : {1.0, -1.0, -1.0}) {
    for (int i = 0; i < 5; ++i) {
      sum.add_product(sign * kLargest, kLargest, kLargest);
      sum.add_product(kSmallest, kSmallest, -sign * kSmallest);
      const mpq_class largest(kLargest), smallest(kSmallest), turn(sign);
      expected += turn * largest * largest * largest;
      expected -= turn * smallest * smallest * smallest;
    }
  }
  EXPECT_EQ(sum.value(), expected);
}

TEST(ExactSum, is_that_of_rationals_over_the_whole_range) {
  std::mt19937_64 random(1);
  for (const int range : {4, 60, 1000}) {
    const auto number = [&] {
      const double mantissa = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
      return std::ldexp(mantissa, static_cast<int>(random() % (2 * range + 1)) - range);
    };
    for (int round = 0; round < 20; ++round) {
      std::vector<Factors> products;
      for (std::uint64_t i = random() % 100; i > 0; --i) {
        products.push_back({number(), number(), number()});
      }
      ASSERT_EQ(exact_sum(products), rational_sum(products));
    }
  }
}

TEST(ExactSum, carries_over_all_digits) {
  // 2^1000 - 2^-1000, less the same: the borrow goes through 2000 bits and back.
  const std::vector<Factors> products = {
      {0x1p1000, 1, 1}, {-0x1p-1000, 1, 1}, {-0x1p1000, 1, 1}, {0x1p-1000, 1, 1}};
  EXPECT_EQ(exact_sum(products), 0);
  EXPECT_EQ(exact_sum({products[0], products[1]}), rational_sum({products[0], products[1]}));
  EXPECT_EQ(exact_sum({}), 0);
}

}  // namespace
}  // namespace dupin::exact
