#pragma once

#include <cmath>
#include <string>

#include "dupin/kernel/decimal.h"

namespace dupin::assembly {

/// Numbers of a document stay within these bounds, so that the sixth powers in the regularity
/// proofs neither overflow nor vanish.
inline constexpr double kLargest = 1e12, kSmallest = 1e-12;

/// Of a positive number.
[[nodiscard]] inline bool is_within_bounds(double value) {
  return value >= kSmallest && value <= kLargest;
}

/// What is said of one that is not: "between 1e-12 and 1e12, not 1.00001e+12".
[[nodiscard]] inline std::string bounds_and(double value) {
  const bool is_near = std::isfinite(value) && value > 0;  // and may be a bound but for its end
  return "between 1e-12 and 1e12, not " + (!is_near           ? decimal(value, kMessageDigits)
                                           : value > kLargest ? decimal_at_most(value)
                                                              : decimal_at_least(value));
}

}  // namespace dupin::assembly
