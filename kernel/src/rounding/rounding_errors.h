#pragma once

#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"

namespace dupin::rounding {

/// Throws invalid_argument unless the options make sense.
void validate(const RoundingOptions& options);

/// There is no valid mesh on such coordinates within the tolerance, for what is at the place given;
/// with what would help. `is_far`: the solid is smaller than its distance from the origin.
[[nodiscard]] Error unroundable_error(const Vec3& at, double tolerance, Coordinates coordinates,
                                      bool is_far);

}  // namespace dupin::rounding
