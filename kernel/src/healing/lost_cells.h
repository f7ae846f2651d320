#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::healing {

/// Faces of a soup, what is known of them and what they are around.
struct CellFaces {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;  ///< no two the same, and no two copies
  /// Per face: whether the solid is in front of it (where it is counter-clockwise), or behind it.
  std::span<const std::uint8_t> solid_in_front, solid_behind;
  /// Whether it was turned over; empty where that tells nothing. Else what only such faces on the
  /// boundary are around, or only others, was no material before.
  std::span<const std::uint8_t> is_turned;
};

/// A face that a cell is behind.
struct CellFace {
  std::uint32_t face;
  bool is_turned;
};

/// What faces bound, as far as they meet in edges, and is outside of the solid, though a face of it
/// is not on the boundary of that.
struct LostCell {
  std::vector<CellFace> walls;
  /// None of them is on the boundary, or it lies between where the solid touches itself along an
  /// edge: what bodies that cross have in common. What a sheet closes is neither.
  bool is_of_bodies = false;
};
[[nodiscard]] std::vector<LostCell> find_lost_cells(const CellFaces& faces);

}  // namespace dupin::healing
