#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Doubles as small integers, for exact results by a few operations of fixed width.
namespace dupin::exact {

__extension__ using Int128 = __int128;

/// Coordinates along one axis in steps of 2^unit, each below 2^60 in size, if they are whole.
template <std::size_t N>
struct LatticeSteps {
  std::array<std::int64_t, N> steps{};
  int unit = 0;
  bool are_whole = true;
};

/// In steps of 2^-60 of the power of two above the largest; none are whole if that is not between
/// 2^-900 and 2^900. Scaling by a power of two is exact unless it underflows, and then scaling back
/// does not give the coordinate.
template <std::size_t N>
[[nodiscard]] LatticeSteps<N> lattice_steps(const std::array<double, N>& x) {
  constexpr int kBits = 60, kMantissaBits = 52, kBias = 1023, kLargestUnit = 900;
  std::uint64_t largest = 0;
  for (const double value : x) {
    largest = std::max(largest, std::bit_cast<std::uint64_t>(value) & ~(std::uint64_t{1} << 63));
  }
  LatticeSteps<N> result;
  if (largest == 0) {
    return result;
  }
  result.unit = static_cast<int>(largest >> kMantissaBits) - (kBias - 1) - kBits;
  result.are_whole = -kLargestUnit <= result.unit && result.unit <= kLargestUnit;
  if (!result.are_whole) {
    return result;
  }
  const auto power_of_two = [](int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(kBias + exponent) << kMantissaBits);
  };
  const double per_unit = power_of_two(-result.unit), of_unit = power_of_two(result.unit);
  for (std::size_t i = 0; i < N; ++i) {
    result.steps[i] = static_cast<std::int64_t>(x[i] * per_unit);
    result.are_whole &= static_cast<double>(result.steps[i]) * of_unit == x[i];
  }
  return result;
}

/// high * 2^64 + low.
struct Int192 {
  Int128 high = 0;
  std::uint64_t low = 0;
};

/// Of vectors with coordinates below 2^61 in size: of their product, they are below 2^123.
[[nodiscard]] inline std::array<Int128, 3> cross(const std::array<std::int64_t, 3>& u,
                                                 const std::array<std::int64_t, 3>& v) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    return Int128{u[i]} * v[k] - Int128{u[k]} * v[i];
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// Of such a product with a third such vector. Lemma: the products of the lower halves, below 2^64,
/// are below 2^125, and so three of them below 2^127; the result is below 2^186.
[[nodiscard]] inline Int192 dot(const std::array<Int128, 3>& normal,
                                const std::array<std::int64_t, 3>& d) {
  Int128 high = 0, low = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    high += (normal[k] >> 64) * d[k];
    low += Int128{static_cast<std::uint64_t>(normal[k])} * d[k];
  }
  return {high + (low >> 64), static_cast<std::uint64_t>(low)};
}

}  // namespace dupin::exact
