#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace dupin::text {

/// The digits that a text begins with: their number modulo 2^64, and where they end.
struct DigitRun {
  std::uint64_t value;
  const char* end;
};

/// The number whose decimal digits, most significant first, are the bytes of `digits` from the
/// lowest to the highest: neighbours are joined to numbers of 2, 4 and 8 digits.
constexpr std::uint64_t joined_digits(std::uint64_t digits) {
  digits = digits * 10 + (digits >> 8);
  digits = (digits & 0x00ff00ff00ff00ffU) * 100 + ((digits >> 16) & 0x00ff00ff00ff00ffU);
  return (digits & 0xffffU) * 10000 + ((digits >> 32) & 0xffffU);
}

/// Eight characters at once, as in Lemire, "Number parsing at a gigabyte per second" (2021).
class EightCharacters {
 public:
  explicit EightCharacters(const char* begin) {
    std::memcpy(&digits_, begin, sizeof digits_);
    digits_ ^= 0x3030303030303030U;  // digits become 0 to 9, all other characters more
    // A byte of 10 or more gets its highest bit by the sum or has it; below the first such byte no
    // sum carries.
    others_ = ((digits_ + 0x7676767676767676U) | digits_) & 0x8080808080808080U;
  }
  [[nodiscard]] bool all_digits() const { return others_ == 0; }
  /// Of all eight.
  [[nodiscard]] std::uint64_t number() const { return joined_digits(digits_); }
  /// Digits before the first other character; there is one.
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::countr_zero(others_)) / 8;
  }
  /// Of these digits.
  [[nodiscard]] std::uint64_t number_before_other() const {
    return joined_digits(digits_ << 4 << (60 - 8 * count()));  // zeros in front
  }

 private:
  std::uint64_t digits_ = 0, others_ = 0;
};

inline constexpr std::array<std::uint64_t, 9> kTens = {1,      10,      100,      1000,     10000,
                                                       100000, 1000000, 10000000, 100000000};

/// Up to seven digits, if a text has eight characters and not all of them are digits; otherwise
/// none.
[[nodiscard]] inline DigitRun take_few_digits(const char* begin, const char* end) {
  if (end - begin >= 8) {
    const EightCharacters next(begin);
    if (!next.all_digits()) {
      return {next.number_before_other(), begin + next.count()};
    }
  }
  return {0, begin};
}

/// All of them. `value` is the number of the digits before.
[[nodiscard]] inline DigitRun take_digits(const char* begin, const char* end,
                                          std::uint64_t value = 0) {
  for (; end - begin >= 8; begin += 8) {
    const EightCharacters next(begin);
    if (!next.all_digits()) {
      const std::size_t count = next.count();
      return {value * kTens[count] + next.number_before_other(), begin + count};
    }
    value = value * kTens[8] + next.number();
  }
  for (; begin != end && *begin >= '0' && *begin <= '9'; ++begin) {
    value = 10 * value + static_cast<std::uint64_t>(*begin - '0');
  }
  return {value, begin};
}

/// The double nearest to a decimal, ties to even, and where the decimal ends; null if it was not
/// read.
struct PlainDecimal {
  double value;
  const char* end;
};

/// Reads what most numbers in files are: digits with or without a minus before and a point between
/// them, at most 19. What follows them may be an exponent. Also leaves a few such decimals, very
/// near to the middle between two doubles, to std::from_chars, which is slower.
[[nodiscard]] PlainDecimal read_plain_decimal(const char* begin, const char* end);

}  // namespace dupin::text
