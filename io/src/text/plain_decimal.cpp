#include "text/plain_decimal.h"

#include <optional>

namespace dupin::text {
namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr int kMostDigits = 19;  // their number is less than 2^64

/// 10^-places = reciprocal * 2^-shift with reciprocal in [2^63, 2^64), which is rounded down.
struct NegativePower {
  std::uint64_t reciprocal;
  int shift;
  double inverse;  ///< 10^places, exact up to 10^22
};

constexpr std::array<NegativePower, kMostDigits + 1> negative_powers() {
  std::array<NegativePower, kMostDigits + 1> table = {};
  std::uint64_t five = 1, ten = 1;
  for (int places = 0; places <= kMostDigits; ++places) {
    // For 5^0 the reciprocal 2^64 has no room; the table is not asked for it.
    const int width = 64 - std::countl_zero(five);
    table[places] = {static_cast<std::uint64_t>((Uint128{1} << (63 + width)) / five),
                     63 + width + places, static_cast<double>(ten)};
    five *= 5;
    ten *= 10;
  }
  return table;
}

constexpr std::array<NegativePower, kMostDigits + 1> kNegativePowers = negative_powers();

constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// digits * 10^-places, rounded to nearest. Nothing if the bounds below do not decide it.
std::optional<double> nearest(std::uint64_t digits, int places) {
  const NegativePower& scale = kNegativePowers[static_cast<std::size_t>(places)];
  if (places == 0 || digits == 0) {
    return static_cast<double>(digits);
  }
  // The product of 64-bit numbers is too small by less than digits << zeros < 2^64, for the
  // reciprocal is too small by less than 1: the exact value is in [high, high + 2) 2^exponent.
  const int zeros = std::countl_zero(digits);
  const auto high = static_cast<std::uint64_t>(Uint128{digits << zeros} * scale.reciprocal >> 64);
  const int exponent = 64 - zeros - scale.shift;
  // high >= 2^62, of which 53 bits stay.
  const int spare = (high >> 63) != 0 ? 11 : 10;
  const std::uint64_t half = std::uint64_t{1} << (spare - 1);
  const std::uint64_t rest = high & (2 * half - 1);
  if (rest == half || rest == half - 1) {
    // The quotient of two numbers that doubles hold is rounded once.
    const bool exact = digits <= std::uint64_t{1} << 53;
    return exact ? std::optional(static_cast<double>(digits) / scale.inverse) : std::nullopt;
  }
  const auto mantissa = static_cast<std::int64_t>((high >> spare) + (rest > half ? 1 : 0));
  return static_cast<double>(mantissa) * power_of_two(exponent + spare);
}

}  // namespace

PlainDecimal read_plain_decimal(const char* begin, const char* end) {
  constexpr PlainDecimal kNone = {0, nullptr};
  const bool negative = begin != end && *begin == '-';
  begin += negative ? 1 : 0;
  DigitRun digits = take_digits(begin, end);
  std::ptrdiff_t count = digits.end - begin;
  std::ptrdiff_t places = 0;
  if (count > 0 && digits.end != end && *digits.end == '.') {
    const char* const point = digits.end;
    digits = take_digits(point + 1, end, digits.value);
    places = digits.end - (point + 1);
    count = places == 0 ? 0 : count + places;
  }
  if (count == 0 || count > kMostDigits) {
    return kNone;
  }
  const auto value = nearest(digits.value, static_cast<int>(places));
  return value ? PlainDecimal{negative ? -*value : *value, digits.end} : kNone;
}

}  // namespace dupin::text
