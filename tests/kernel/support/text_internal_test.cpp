#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/text.h"

namespace dupin::support {
namespace {

TEST(Text, reads_back_to_the_same_double) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      EXPECT_EQ(std::strtod(text(value).c_str(), nullptr), value);
    }
  }
}

// A double has so few digits if that many in the notation of printf read back to it.
TEST(Text, has_no_more_digits_than_the_double_needs) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  const auto digits = [](const std::string& s) {
    return std::count_if(s.begin(), s.begin() + static_cast<std::ptrdiff_t>(s.find_first_of("eE")),
                         [](char c) { return c >= '0' && c <= '9'; });
  };
  for (int i = 0; i < 2000; ++i) {
    const double value = i % 2 == 0 ? uniform(random) : std::round(uniform(random) * 8) / 8;
    char shortest[64];
    for (int precision = 0; precision < 17; ++precision) {
      (void)std::snprintf(shortest, sizeof shortest, "%.*e", precision, value);
      if (std::strtod(shortest, nullptr) == value) {
        break;
      }
    }
    const std::string scientific(shortest);
    // Plain notation may have zeros before and after them.
    EXPECT_LE(text(value).size(), scientific.size() + 3) << text(value);
    EXPECT_GE(digits(text(value) + "e"), digits(scientific)) << text(value);
  }
}

TEST(Text, writes_round_numbers_plainly) {
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(-2.5), "-2.5");
  EXPECT_EQ(text(0.1), "0.1");
  EXPECT_EQ(text(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(text(Vec3(1, -0.5, 1e100)), "(1, -0.5, 1e+100)");
}

}  // namespace
}  // namespace dupin::support
