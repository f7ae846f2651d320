#pragma once

#include <cmath>

#include "dupin/kernel/coordinates.h"

namespace dupin::exact {

/// The numbers a coordinate may be rounded to: binary64 numbers in range (is_in_range) or binary32
/// numbers, and of those the multiples of a spacing.
class FloatLattice {
 public:
  /// `spacing` is a power of two, or 0 for none.
  explicit FloatLattice(Coordinates coordinates, double spacing = 0)
      : digits_(coordinates == Coordinates::binary64 ? 53 : 24),
        least_exponent_(coordinates == Coordinates::binary64 ? -1074 : -149),
        least_number_(coordinates == Coordinates::binary64 ? -199 : -149),
        spacing_(spacing) {}

  /// True if every double belongs to it.
  [[nodiscard]] bool holds_doubles() const { return digits_ == 53 && spacing_ == 0; }

  /// The distance to the next number of the lattice away from 0; `value` need not belong to it.
  [[nodiscard]] double step(double value) const {
    const int exponent =
        value == 0 ? least_number_ : std::max(std::ilogb(value) - digits_ + 1, least_exponent_);
    return std::max(std::ldexp(1.0, exponent), spacing_);
  }

  /// The nearest number to an exact one, ties to even: `value` is the double nearest to the exact
  /// one and remainder() the sign of the exact one minus `value`, asked for only in a tie.
  template <class Remainder>
  [[nodiscard]] double nearest(double value, Remainder&& remainder) const {
    if (holds_doubles()) {
      return std::abs(value) < kLeastCoordinate ? 0.0 : value;
    }
    const double unit = step(value);
    const double multiple = value / unit, floor = std::floor(multiple);
    double excess = multiple - floor - 0.5;
    if (excess == 0) {
      excess = remainder();
    }
    const bool odd = std::fmod(floor, 2) != 0;
    const bool up = excess > 0 || (excess == 0 && odd);
    return (floor + (up ? 1 : 0)) * unit + 0.0;
  }
  [[nodiscard]] double nearest(double value) const {
    constexpr double kFarFromOverflow = 0x1p127;  // in binary32
    if (digits_ == 24 && spacing_ == 0 && std::abs(value) < kFarFromOverflow) {
      return dupin::nearest(value, Coordinates::binary32) + 0.0;
    }
    return nearest(value, [] { return 0; });
  }
  [[nodiscard]] Vec3 nearest(const Vec3& point) const {
    return {nearest(point.x()), nearest(point.y()), nearest(point.z())};
  }

  /// The number of the lattice `count` steps above `value`, which belongs to it.
  [[nodiscard]] double shifted(double value, int count) const;

 private:
  int digits_, least_exponent_, least_number_;
  double spacing_;
};

}  // namespace dupin::exact
