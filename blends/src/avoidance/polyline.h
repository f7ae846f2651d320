#pragma once

#include <optional>
#include <span>
#include <vector>

#include "avoidance/obstacle.h"
#include "dupin/blends/ringed_surface.h"

namespace dupin::avoidance {

/// A way of straight pipes and torus elbows from ring to ring ([mathematics A8], the last resort),
/// their normals pointing out of their parts: the shortest of those along the axes of a lattice of
/// points that keep clear, straightened, its corners rounded by the largest elbows that fit, and
/// proved to keep at least `clearance` from all obstacles. The radius changes on the longest leg.
/// None if no such way is found. O(n k) for n points of the lattice, at most some ten thousands,
/// and k obstacles near each.
[[nodiscard]] std::optional<std::vector<RingedSurface>> polyline_pipe(
    const Ring& from, const Ring& to, std::span<const NamedObstacle> obstacles, double clearance);

}  // namespace dupin::avoidance
