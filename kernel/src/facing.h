#pragma once

#include "triangle_distance.h"

namespace dupin::detail {

/// Whether the cosine of the angle between one triangle's normal and the other's reversed is at
/// least `cosine` > 0, exactly.
[[nodiscard]] bool opposed(const ExactTriangle& a, const ExactTriangle& b, double cosine);

/// Whether part of `b`, of some area, lies straight in front of `a`: above it along its normal, not
/// in its plane. The triangles are opposed.
[[nodiscard]] bool in_front(const ExactTriangle& a, const ExactTriangle& b);

}  // namespace dupin::detail
