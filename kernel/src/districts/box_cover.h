#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <gmpxx.h>

namespace dupin::districts {

/// The corners of a plane convex polygon, in order; or of a segment, or one point.
using Polygon = std::vector<std::array<mpq_class, 3>>;

/// Whether the interiors of the boxes together contain the polygon, exactly. Each box in turn
/// leaves what is not in its interior, in up to six pieces, to the others.
[[nodiscard]] bool is_covered(Polygon polygon, std::span<const Eigen::AlignedBox3d> boxes);

}  // namespace dupin::districts
