#pragma once

#include <cstdint>

#include "arrangement/implicit_points.h"

namespace dupin::arrangement {

/// An edge by its ends, the lower one first.
using EdgeKey = std::uint64_t;
[[nodiscard]] constexpr EdgeKey edge_key(PointId a, PointId b) {
  return a < b ? (EdgeKey{a} << 32 | b) : (EdgeKey{b} << 32 | a);
}
[[nodiscard]] constexpr PointId lower_end(EdgeKey edge) { return static_cast<PointId>(edge >> 32); }
[[nodiscard]] constexpr PointId upper_end(EdgeKey edge) { return static_cast<PointId>(edge); }

}  // namespace dupin::arrangement
