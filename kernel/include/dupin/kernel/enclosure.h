#pragma once

#include <gmpxx.h>

namespace dupin {

/// An interval of doubles that certainly contains an exact value; lower == upper says that the
/// value is that double.
struct Enclosure {
  double lower = 0, upper = 0;

  [[nodiscard]] bool contains(double value) const { return lower <= value && value <= upper; }
  [[nodiscard]] Enclosure operator-() const { return {0.0 - upper, 0.0 - lower}; }
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// The two doubles around `value`, or twice the one that it is.
[[nodiscard]] Enclosure enclosure_of(const mpq_class& value);

/// Encloses the square root of `square` >= 0; exact when the root is a double.
[[nodiscard]] Enclosure root_of(const mpq_class& square);

/// Encloses the angle in [0, pi] with sine and cosine in the ratio of the root of `sine_squared` >=
/// 0 to `cosine`, not both zero. Exactly 0 for sine 0 and positive cosine.
[[nodiscard]] Enclosure angle_of(const mpq_class& sine_squared, const mpq_class& cosine);

/// Encloses a sum, rounding outward. Bounds may be infinite. Throws Error{invalid_argument} where
/// one is no number, or lower or upper ones are infinite the other way, so that nothing is
/// enclosed.
[[nodiscard]] Enclosure operator+(const Enclosure& a, const Enclosure& b);

}  // namespace dupin
