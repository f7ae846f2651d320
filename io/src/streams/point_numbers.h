#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "streams/spilled_meshes.h"

namespace dupin::streams {

/// A border of a piece, and the same one of another, which is told by its place among those that
/// are numbered.
struct SharedBorder {
  std::size_t border, piece, of_piece;
};

/// What the points of a piece are called among those of several, if each place of a border that
/// two of them share is one point, of the piece that comes first.
struct PointNumbers {
  std::uint32_t first = 0;  ///< of the points that are in no piece before
  std::vector<std::pair<std::uint32_t, std::uint32_t>> known;  ///< the others, and their numbers
  std::vector<SharedBorder> shared;

  [[nodiscard]] std::uint32_t of(std::uint32_t point) const;
};

struct NumberedPoints {
  std::vector<PointNumbers> pieces;
  std::uint64_t count = 0;
};

/// Of these pieces, one after the other. They may be elsewhere.
[[nodiscard]] NumberedPoints numbered_points(const SpilledMeshes& meshes,
                                             std::span<const std::size_t> pieces);

}  // namespace dupin::streams
