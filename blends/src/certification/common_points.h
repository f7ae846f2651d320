#pragma once

#include <vector>

#include "certification/swept_discs.h"

namespace dupin::certification {

/// Points that are thought to lie inside both parts, found by going from one to the other and back,
/// the deepest first; none of long chains. Plain arithmetic: whoever claims it of one has to prove
/// it.
[[nodiscard]] std::vector<Vec3> common_points(const SweptDiscs& first, const SweptDiscs& second);

}  // namespace dupin::certification
