#include "dupin/kernel/decimal.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(DecimalText, is_the_shortest) {
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(decimal(-2.0), "-2");
  EXPECT_EQ(decimal(1e22), "1e+22");
  EXPECT_EQ(decimal(-0.0), "-0");
  EXPECT_EQ(decimal(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(decimal(std::numeric_limits<double>::lowest()), "-1.7976931348623157e+308");
  EXPECT_EQ(decimal(std::numeric_limits<double>::infinity()), "inf");
}

TEST(DecimalText, reads_back_to_the_same_double) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) {
      continue;
    }
    const std::string text = decimal(value);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    ASSERT_EQ(read, value) << text;
  }
}

TEST(DecimalText, has_as_many_digits_as_asked) {
  EXPECT_EQ(decimal(1.0 / 3, 3), "0.333");
  EXPECT_EQ(decimal(2.0 / 3, 9), "0.666666667");
  EXPECT_EQ(decimal(0.5, 9), "0.5") << "no zeros at the end";
  EXPECT_EQ(decimal(123456, 2), "1.2e+05");
  EXPECT_EQ(decimal(-std::numeric_limits<double>::min() / 3, 17), "-7.4169128616906696e-309");
}

TEST(DecimalText, of_a_point_is_a_triple) {
  EXPECT_EQ(decimal(Vec3(1, -0.25, 1e-9)), "(1, -0.25, 1e-09)");
}

TEST(DecimalText, of_bounds_are_bounds) {
  EXPECT_EQ(decimal_at_most(0.5), "0.5");
  EXPECT_EQ(decimal_at_most(1.0 / 3), "0.333334");
  EXPECT_EQ(decimal_at_most(-1.0 / 3), "-0.333333");
  EXPECT_EQ(decimal_at_least(1.0 / 3), "0.333333");
  EXPECT_EQ(decimal_at_least(-1.0 / 3), "-0.333334");
  EXPECT_EQ(decimal_at_least(0), "0");
  double value = 1;
  for (int i = 0; i < 2000; ++i) {
    value = value > 1e100 ? value * 1e-200 : value * 1.7320508;
    for (const double x : {value, -value}) {
      const std::string most = decimal_at_most(x), least = decimal_at_least(x);
      EXPECT_GE(std::stod(most), x) << most;
      EXPECT_LE(std::stod(least), x) << least;
      EXPECT_NEAR(std::stod(most) / x, 1, 2e-5);
      EXPECT_NEAR(std::stod(least) / x, 1, 2e-5);
    }
  }
}

TEST(DecimalText, of_places_tells_them_in_a_plant) {
  EXPECT_EQ(decimal(Vec3(1712345.678, -0.1, 1e-7 / 3)), "(1712345.68, -0.1, 3.33333333e-08)");
}

TEST(DecimalText, is_appended_in_the_precision_of_its_type) {
  std::string text = "x ";
  append_decimal(text, 0.1F);
  text += ' ';
  append_decimal(text, static_cast<double>(0.1F));
  text += ' ';
  append_decimal(text, std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(text, "x 0.1 0.10000000149011612 4294967295");
}

TEST(DecimalText, of_bytes_is_in_the_unit_that_suits_it_and_rounded_up) {
  EXPECT_EQ(byte_size(1), "1 kB");
  EXPECT_EQ(byte_size(850'629), "860 kB");
  EXPECT_EQ(byte_size(999'999), "1 MB");
  EXPECT_EQ(byte_size(4e9), "4 GB");
  EXPECT_EQ(byte_size(1.21e13), "13 TB");
}

}  // namespace
}  // namespace dupin
