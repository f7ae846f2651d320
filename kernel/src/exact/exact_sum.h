#pragma once

#include <array>
#include <cstdint>

#include <gmpxx.h>

namespace dupin::exact {

/// The exact sum of products of three doubles: a fixed-point number wide enough for any of them
/// (Kulisch's accumulator). An addition costs a few integer operations, whatever the range of the
/// numbers. Holds up to 2^100 products.
class ExactSum {
 public:
  /// Adds a * b * c; they are finite.
  void add_product(double a, double b, double c);
  [[nodiscard]] mpq_class value() const;

 private:
  // A double is an integer times 2^-1074 or a higher power, so a product of three is a multiple of
  // 2^-3222. It is less than 2^3072, which leaves 106 bits of the 6400 to the sum.
  static constexpr int kFractionBits = 3 * 1074;
  static constexpr std::size_t kDigits = 100;
  using Digits = std::array<std::uint64_t, kDigits>;

  Digits positive_{}, negative_{};  // least significant first
};

}  // namespace dupin::exact
