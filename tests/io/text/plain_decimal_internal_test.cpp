#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "text/plain_decimal.h"

namespace dupin {
namespace {

std::size_t digits_read(std::string_view text) {
  return static_cast<std::size_t>(text::take_digits(text.data(), text.data() + text.size()).end -
                                  text.data());
}

TEST(Decimal, takes_digits_up_to_the_first_other_character) {
  const std::string digits = "90123456789012345678";
  for (std::size_t count = 0; count < digits.size(); ++count) {
    for (std::size_t more = 0; more < 10; ++more) {
      for (int other = 0; other < 256; ++other) {
        if (other >= '0' && other <= '9') {
          continue;
        }
        const std::string text =
            digits.substr(0, count) + static_cast<char>(other) + std::string(more, '7');
        ASSERT_EQ(digits_read(text), count) << text;
      }
      ASSERT_EQ(digits_read(digits.substr(0, count)), count);
    }
  }
}

TEST(Decimal, knows_the_number_of_the_digits) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 100000; ++round) {
    const std::uint64_t number = random() >> (random() % 64);
    const std::string text = std::to_string(number) + (round % 2 == 0 ? "" : " 12345678");
    ASSERT_EQ(text::take_digits(text.data(), text.data() + text.size()).value, number) << text;
  }
}

/// Whether it was read; what is read must be what std::from_chars finds.
bool reads_as_the_library(const std::string& text) {
  double expected = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
  const text::PlainDecimal found = text::read_plain_decimal(text.data(), text.data() + text.size());
  if (found.end == nullptr) {
    return false;
  }
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found.value), std::bit_cast<std::uint64_t>(expected))
      << text;
  EXPECT_EQ(found.end, end) << text;
  EXPECT_EQ(error, std::errc()) << text;
  return true;
}

TEST(Decimal, reads_the_shortest_decimals_of_doubles) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> mantissa(0.5, 1);
  int read = 0;
  constexpr int kRounds = 300000;
  for (int round = 0; round < kRounds; ++round) {
    const double size = std::ldexp(mantissa(random), static_cast<int>(random() % 20));
    const double value = round % 2 == 0 ? size : -size;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    read += reads_as_the_library({text.data(), end}) ? 1 : 0;
  }
  EXPECT_GT(read, kRounds * 99 / 100) << "it would be of no use";
}

TEST(Decimal, reads_decimals_of_any_length) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 300000; ++round) {
    std::string text = std::to_string(random() >> (random() % 64));
    text.insert(random() % (text.size() + 1), ".");
    text.insert(0, random() % 3, '0');
    (void)reads_as_the_library((random() % 2 == 0 ? "-" : "") + text);
  }
}

TEST(Decimal, rounds_ties_and_their_neighbours_as_the_library) {
  std::mt19937_64 random(4);
  for (std::uint64_t places = 0, power = 1; places <= 4; ++places, power *= 5) {
    for (int round = 0; round < 20000; ++round) {
      // An odd number of 54 bits over 2^places is in the middle between two doubles.
      const std::uint64_t odd = (random() >> 11) | (std::uint64_t{1} << 53) | 1;
      for (const std::uint64_t digits : {odd * power - 1, odd * power, odd * power + 1}) {
        std::string text = std::to_string(digits);
        text.insert(text.size() - places, places == 0 ? "" : ".");
        (void)reads_as_the_library(text);
      }
    }
  }
}

TEST(Decimal, leaves_other_forms_to_the_library) {
  for (const char* const text :
       {"", "-", ".", "-.5", "5.", "+5", "inf", "nan", "12345678901234567890"}) {
    EXPECT_FALSE(reads_as_the_library(text)) << text;
  }
  const std::string_view exponent = "12.5e3";
  EXPECT_EQ(text::read_plain_decimal(exponent.data(), exponent.data() + exponent.size()).end,
            exponent.data() + 4);
}

}  // namespace
}  // namespace dupin
