#pragma once

#include "numbers/interval.h"

namespace dupin::numbers {

struct CosineAndSine {
  Interval cosine, sine;
};

/// Enclosures for all x of the interval, wider than they must be by a few doubles and, near zeros,
/// 1e-24. [-1, 1] where |x| > 1000.
[[nodiscard]] CosineAndSine cosine_and_sine(const Interval& x);

/// Of (x - pi/2) / 2.
[[nodiscard]] CosineAndSine cosine_and_sine_of_half_beyond_quarter(const Interval& x);

}  // namespace dupin::numbers
