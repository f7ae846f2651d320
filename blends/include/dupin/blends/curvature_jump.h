#pragma once

#include "dupin/blends/tangency.h"

namespace dupin {

/// An upper bound, by interval arithmetic on the stored numbers, of the normal curvature that the
/// surface has along its parameter lines at an end ring. The cylinder or cone beyond the ring has
/// none in its rulings' directions; so where the tangent planes agree, this is the jump of
/// curvature [MS06].
///
/// Throws Error{irregular_surface} where the spine stops or the surface folds at that end.
[[nodiscard]] double curvature_jump_bound(const RingedSurface& surface, End end);

}  // namespace dupin
