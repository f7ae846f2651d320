#pragma once

#include <vector>

#include "dupin/kernel/mesh_gap.h"
#include "face_boxes.h"

namespace dupin::detail {

/// The regions of faces of a and b that look at each other, as measure_gaps says.
[[nodiscard]] std::vector<FacingRegion> facing_regions(const MeshPair& pair, const FaceBoxes& boxes,
                                                       const MeshGapOptions& options);

}  // namespace dupin::detail
