#include "predicates/lattice_orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace dupin::predicates {
namespace {

__extension__ using Int128 = __int128;

constexpr int kBits = 60;
constexpr int kMantissaBits = 52;

/// Positions of the bits of doubles, the lowest one that a double can have being 0: from the lowest
/// set in any to above the highest.
struct BitRange {
  int low = std::numeric_limits<int>::max(), high = 0;

  void join(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
    if (bits == 0) {
      return;
    }
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << kMantissaBits) - 1);
    const int exponent = static_cast<int>(bits >> kMantissaBits);  // 0 for denormals
    const int shift = std::max(exponent, 1) - 1;
    const std::uint64_t mantissa =
        exponent == 0 ? fraction : fraction | std::uint64_t{1} << kMantissaBits;
    low = std::min(low, shift + std::countr_zero(mantissa));
    high = std::max(high, shift + static_cast<int>(std::bit_width(mantissa)));
  }
};

/// The double 2^exponent, which is normal.
double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << kMantissaBits);
}

/// b - a, c - a and p - a along an axis, in units of it.
std::optional<std::array<std::int64_t, 3>> differences(double a, double b, double c, double p) {
  BitRange range;
  for (const double x : {a, b, c, p}) {
    range.join(x);
  }
  if (range.high == 0) {
    return std::array<std::int64_t, 3>{};  // all are 0
  }
  const int unit = range.low - 1074;  // its exponent
  constexpr int kLargestExponent = 1022;
  if (range.high - range.low > kBits || -unit > kLargestExponent || unit > kLargestExponent) {
    return std::nullopt;
  }
  const double per_unit = power_of_two(-unit);
  const auto steps = [per_unit](double x) { return static_cast<std::int64_t>(x * per_unit); };
  const std::int64_t origin = steps(a);
  return std::array{steps(b) - origin, steps(c) - origin, steps(p) - origin};
}

}  // namespace

std::optional<int> lattice_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == b[k] && a[k] == c[k] && a[k] == p[k]) {
      return 0;  // in a plane across an axis, as many are, whatever the others
    }
  }
  std::array<std::array<std::int64_t, 3>, 3> d;  // by axis
  for (int k = 0; k < 3; ++k) {
    const auto along = differences(a[k], b[k], c[k], p[k]);
    if (!along) {
      return std::nullopt;
    }
    d[static_cast<std::size_t>(k)] = *along;
  }
  Int128 high = 0, low = 0;  // high * 2^64 + low
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &u = d[(k + 1) % 3], &v = d[(k + 2) % 3];
    const Int128 minor = Int128{u[0]} * v[1] - Int128{u[1]} * v[0];
    const Int128 factor = d[k][2];
    high += (minor >> 64) * factor;
    low += Int128{static_cast<std::uint64_t>(minor)} * factor;
  }
  high += low >> 64;
  if (high != 0) {
    return high > 0 ? 1 : -1;
  }
  return static_cast<std::uint64_t>(low) != 0 ? 1 : 0;
}

}  // namespace dupin::predicates
