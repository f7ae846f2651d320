#pragma once

#include <vector>

#include "dupin/kernel/mesh_gap.h"
#include "gaps/mesh_pair.h"
#include "predicates/triangle_distance.h"

namespace dupin::gaps {

/// Whether the cosine of the angle between one triangle's normal and the other's reversed is at
/// least `cosine` > 0, exactly.
[[nodiscard]] bool opposed(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b,
                           double cosine);

/// Whether part of `b`, of some area, lies straight in front of `a`: above it along its normal, not
/// in its plane. The triangles are opposed.
[[nodiscard]] bool in_front(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b);

/// The regions of faces of a and b that look at each other, as measure_gaps says.
[[nodiscard]] std::vector<GapRegion> gap_regions(const MeshPair& pair, const FaceBoxIndex& boxes,
                                                 const MeshGapOptions& options);

}  // namespace dupin::gaps
