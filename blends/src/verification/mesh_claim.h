#pragma once

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// What snapping to the grid and the rounding of coordinates of this size may add.
[[nodiscard]] Interval displacement(double grid, double size);

/// Whether the claim follows from the part's numbers.
[[nodiscard]] bool follows(const Solid& solid, const MeshClaim& claim);

}  // namespace dupin::verification
