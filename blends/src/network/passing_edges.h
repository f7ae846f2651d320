#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
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

/// What a node became, and an edge, or what another node became, that is not joined to it.
struct PassingNode {
  std::size_t node = 0;
  std::optional<std::size_t> edge = {};
  std::size_t other = 0;  ///< where there is no edge; larger than `node`

  auto operator<=>(const PassingNode&) const = default;
};

/// All that come nearer to each other than their radii allow: hubs, balls, bends, and arms where
/// edges are cut back, as pipes of their ends' radii. Of nodes with an edge between them, not what
/// that edge joins. Ascending. O(n log n + k) for k pairs of pieces that overlap along x.
[[nodiscard]] std::vector<PassingNode> passing_nodes(const GraphPlan& plan);

}  // namespace dupin::network
