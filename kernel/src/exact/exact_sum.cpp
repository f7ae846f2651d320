#include "exact/exact_sum.h"

#include <bit>

namespace dupin::exact {
namespace {

__extension__ using Uint128 = unsigned __int128;

// |value| = mantissa * 2^(exponent - 1074), with exponent >= 0.
struct Decoded {
  explicit Decoded(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    negative = (bits >> 63) != 0;
    mantissa = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    exponent = biased == 0 ? 0 : biased - 1;
  }
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

constexpr std::uint64_t low_half(Uint128 value) { return static_cast<std::uint64_t>(value); }
constexpr std::uint64_t high_half(Uint128 value) { return static_cast<std::uint64_t>(value >> 64); }

mpz_class integer(const std::uint64_t* digits, std::size_t count) {
  mpz_class value;
  mpz_import(value.get_mpz_t(), count, -1, sizeof(std::uint64_t), 0, 0, digits);
  return value;
}

}  // namespace

void ExactSum::add_product(double a, double b, double c) {
  const Decoded x(a), y(b), z(c);
  const Uint128 xy = Uint128{x.mantissa} * y.mantissa;
  const Uint128 low = Uint128{low_half(xy)} * z.mantissa;
  const Uint128 high = Uint128{high_half(xy)} * z.mantissa + high_half(low);
  const int exponent = x.exponent + y.exponent + z.exponent;
  const int shift = exponent % 64;
  const std::array<std::uint64_t, 4> shifted = {
      low_half(low) << shift,
      low_half(((Uint128{low_half(high)} << 64) | low_half(low)) >> (64 - shift)),
      low_half(high >> (64 - shift)), shift == 0 ? 0 : high_half(high) >> (64 - shift)};

  Digits& sum = x.negative ^ y.negative ^ z.negative ? negative_ : positive_;
  std::uint64_t* digit = sum.data() + exponent / 64;
  std::uint64_t carry = 0;
  for (const std::uint64_t part : shifted) {
    const Uint128 total = Uint128{*digit} + part + carry;
    *digit++ = low_half(total);
    carry = high_half(total);
  }
  for (; carry != 0; ++digit) {
    carry = ++*digit == 0 ? 1 : 0;
  }
}

mpq_class ExactSum::value() const {
  mpq_class value(integer(positive_.data(), kDigits) - integer(negative_.data(), kDigits));
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), kFractionBits);
  return value;
}

}  // namespace dupin::exact
