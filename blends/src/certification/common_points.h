#pragma once

#include <optional>
#include <vector>

#include "certification/swept_discs.h"

namespace dupin::certification {

/// Where the axes come nearest to each other, between them as the radii in the middle are to each
/// other: of pipes that cross, a point of both. None of long chains. Plain arithmetic, as below.
[[nodiscard]] std::optional<Vec3> point_between_axes(const SweptDiscs& first,
                                                     const SweptDiscs& second);

/// Points that are thought to lie inside both parts, found by going from one to the other and back,
/// the deepest first; none of long chains. Plain arithmetic: whoever claims it of one has to prove
/// it.
[[nodiscard]] std::vector<Vec3> common_points(const SweptDiscs& first, const SweptDiscs& second);

}  // namespace dupin::certification
