#pragma once

#include "predicates/triangle_distance.h"

namespace dupin::gaps {

/// Whether the cosine of the angle between one triangle's normal and the other's reversed is at
/// least `cosine` > 0, exactly.
[[nodiscard]] bool opposed(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b,
                           double cosine);

/// Whether part of `b`, of some area, lies straight in front of `a`: above it along its normal, not
/// in its plane. The triangles are opposed.
[[nodiscard]] bool in_front(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b);

}  // namespace dupin::gaps
