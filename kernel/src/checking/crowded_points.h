#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxes/box.h"
#include "dupin/kernel/mesh.h"
#include "support/bulk_vector.h"

/// Points in which so many triangles meet that boxes around these, which all contain the point, do
/// not tell them apart. Seen from the point they do: two of its triangles meet beyond it only in
/// directions that both have.
namespace dupin::checking {

/// Triangles with a corner in common.
struct CrowdedPoint {
  std::uint32_t point = 0;
  std::vector<std::uint32_t> faces;  ///< ascending
};

/// Points in which more than `many` of the faces given meet, ascending, and which of these each
/// has: every face belongs to one of its corners at most, that in which most meet. Those with an
/// entry other than 0 in `excluded` (one per point, or empty) are left out. O(n).
[[nodiscard]] std::vector<CrowdedPoint> crowded_points(std::span<const Triangle> triangles,
                                                       std::span<const std::uint32_t> faces,
                                                       std::size_t point_count,
                                                       std::span<const std::uint8_t> excluded,
                                                       std::size_t many);

/// Around the directions in which each face is seen from the point: triangles whose boxes do not
/// overlap meet in nothing else. Nothing for faces with an entry other than 0 in `degenerate`,
/// which are asked for by their indices. Coordinates are in range (dupin/kernel/coordinates.h).
[[nodiscard]] support::BulkVector<boxes::Box> direction_boxes(
    std::span<const Vec3> points, std::span<const Triangle> triangles, const CrowdedPoint& crowded,
    std::span<const std::uint8_t> degenerate);

}  // namespace dupin::checking
