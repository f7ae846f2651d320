#pragma once

#include <array>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// The fillet of a ball of this radius between two straight pipes or cones of circular sections:
/// which of the ways round their crossing lie on both, and which ends the other one buries.
///
/// Throws Error{infeasible_blend} that says why there is none and, where a smaller ball would do,
/// the largest radius that would, to two digits; Error{invalid_argument} for other surfaces.
[[nodiscard]] Fillet fillet_between(const std::array<const PartSurface*, 2>& pipes,
                                    const std::array<std::string, 2>& names, double radius);

}  // namespace dupin::assembly
