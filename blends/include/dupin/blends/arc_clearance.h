#pragma once

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/pe_arc.h"

namespace dupin {

/// Whether the tube (the union of the arc's balls) keeps more than `distance` >= 0 from a ball:
/// decided exactly on the given doubles (the start tangent taken to be PE-unit), closed form.
[[nodiscard]] bool keeps_distance(const PeArc& arc, const Sphere& ball, double distance);

/// Whether the point lies inside the tube, its surface not included; decided likewise.
[[nodiscard]] bool contains(const PeArc& arc, const Vec3& point);

/// The largest distance that the tube keeps from a ball; negative where they overlap, as far as
/// the radius that the ball would have to lose. Absolute error below 1e-12 of the size of the data.
[[nodiscard]] double clearance(const PeArc& arc, const Sphere& ball);
[[nodiscard]] double clearance(const CyclideChain& chain, const Sphere& ball);

}  // namespace dupin
