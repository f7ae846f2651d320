#pragma once

#include <span>

#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

/// Whether the surface of a fillet lies beyond that of another one in the same corner, whose ball
/// is larger and whose pipes lie within its own, or is less than `wall` away from it: so that there
/// is no wall between them, though there is one between the pipes. As of walls that differ: the
/// balls are not concentric. By sampled arcs of the outer one and the nearest arcs of the inner
/// one, in doubles.
[[nodiscard]] bool breaks_through(std::span<const CanalFillet> inner,
                                  std::span<const CanalFillet> outer, double wall = 0);

}  // namespace dupin::canal
