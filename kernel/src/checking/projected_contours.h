#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::checking {

/// From a point to another one.
struct DirectedEdge {
  std::uint32_t from, to;
};

/// What keeps directed edges, seen along `axis`, from bounding a region that lies to the left of
/// each if `turn` is +1, to the right if -1: the places of edges that cross others, or about whose
/// ends there is no such region, ascending; none if there is one for certain, wherever each
/// coordinate of each point moves by at most `margin`. At every point, as many edges begin as end.
/// O(n log n) where few boxes of edges overlap.
[[nodiscard]] std::vector<std::uint32_t> region_conflicts(std::span<const Vec3> points,
                                                          std::span<const DirectedEdge> edges,
                                                          int axis, int turn, double margin = 0);

}  // namespace dupin::checking
