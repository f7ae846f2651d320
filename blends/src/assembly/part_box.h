#pragma once

#include <Eigen/Geometry>

#include "dupin/blends/part_surface.h"

namespace dupin::assembly {

/// A box along the axes about all that the surface bounds, in outward rounded arithmetic; infinite
/// where nothing is known of it. O(pieces).
[[nodiscard]] Eigen::AlignedBox3d part_box(const PartSurface& surface);

}  // namespace dupin::assembly
