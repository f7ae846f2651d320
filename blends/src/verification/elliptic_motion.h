#pragma once

#include <array>

#include "verification/motion.h"

namespace dupin::verification {

/// Of the discs about an elliptic tube's sections. Their radius is a jet of bounds: with |x - c|,
/// no point x(t, u) of the sections, seen in a frame that does not spin about the normal, has a
/// first or second derivative by t that is larger than the radius' one. Empty where the numbers do
/// not tell how the axes turn on their way.
[[nodiscard]] Motion elliptic_motion(const EllipticTube& tube, const std::array<Tube, 2>& axes);

}  // namespace dupin::verification
