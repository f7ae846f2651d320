#pragma once

#include <vector>

#include "dupin/kernel/mesh_gap.h"
#include "gaps/face_boxes.h"

namespace dupin::gaps {

/// The regions of faces of a and b that look at each other, as measure_gaps says.
[[nodiscard]] std::vector<GapRegion> gap_regions(const MeshPair& pair, const FaceBoxIndex& boxes,
                                                 const MeshGapOptions& options);

}  // namespace dupin::gaps
