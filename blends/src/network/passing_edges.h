#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "network/graph_plan.h"

namespace dupin::network {

/// Whether two edges' cones, where they are not cut back, come nearer to each other than the sum of
/// their radii: the least of |p(s) - q(t)| - r(s) - r(t), which is convex, nearly. Never those that
/// share a node.
[[nodiscard]] bool pass(const GraphPlan& plan, std::size_t one, std::size_t other);

/// All such pairs, the smaller index first, ascending. O(n log n + k) for k pairs that overlap
/// along x.
[[nodiscard]] std::vector<std::array<std::size_t, 2>> passing_edges(const GraphPlan& plan);

}  // namespace dupin::network
