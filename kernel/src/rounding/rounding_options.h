#pragma once

#include <span>

#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"

namespace dupin::rounding {

/// Throws invalid_argument unless the options make sense.
void validate(const RoundingOptions& options);

/// The place that becomes (0, 0, 0), of all these points if they are the whole: the origin for
/// none.
[[nodiscard]] Vec3 chosen_origin(const RoundingOptions& options, std::span<const Vec3> points);

/// The largest coordinate of the larger whole, in absolute value, from this origin; 0 if there is
/// none.
[[nodiscard]] double largest_of(const RoundingOptions& options, const Vec3& origin);

/// There is no valid mesh on such coordinates within the tolerance, for what is at the place given;
/// with the options that would help. `is_far`: the solid is smaller than its distance from the
/// origin.
[[nodiscard]] Error unroundable_error(const Vec3& at, double tolerance, Coordinates coordinates,
                                      bool is_far);

}  // namespace dupin::rounding
