#pragma once

#include <array>

#include "dupin/blends/spine.h"

namespace dupin {

/// The curve besides the line V0 V3 in which two quadratic cones meet [BWL17] Theorem 1: the first
/// has its apex at V0 and the ridge V1 V2 V3 with weights m, the second its apex at V3 and the
/// ridge V0 V1 V2 with weights w. It is the rational cubic Bezier curve with control points V0 to
/// V3, so it leaves along V0 V1 and arrives along V2 V3.
///
/// Throws Error{invalid_argument} unless the points are finite and the weights positive.
[[nodiscard]] BezierSpine two_cone_spine(const std::array<Vec3, 4>& vertices,
                                         const std::array<double, 3>& m,
                                         const std::array<double, 3>& w);

}  // namespace dupin
