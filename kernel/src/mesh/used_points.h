#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "support/none.h"

namespace dupin::mesh {

/// The points that triangles have, numbered anew without the others.
struct UsedPoints {
  std::vector<std::uint32_t> points;  ///< ascending
  std::vector<std::uint32_t> number;  ///< per point its place among them, or support::kNone

  [[nodiscard]] Triangle renumbered(const Triangle& t) const {
    return {number[t[0]], number[t[1]], number[t[2]]};
  }
};

[[nodiscard]] inline UsedPoints used_points(std::span<const Triangle> triangles,
                                            std::size_t point_count) {
  UsedPoints used{{}, std::vector(point_count, support::kNone)};
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t point : triangle) {
      used.number[point] = 0;
    }
  }
  for (std::uint32_t point = 0; point < point_count; ++point) {
    if (used.number[point] != support::kNone) {
      used.number[point] = static_cast<std::uint32_t>(used.points.size());
      used.points.push_back(point);
    }
  }
  return used;
}

}  // namespace dupin::mesh
