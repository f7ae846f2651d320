#pragma once

#include <cstddef>
#include <vector>

#include "network/clean_graph.h"

namespace dupin::network {

/// For each edge, whether its capsule, of the larger radius, may reach into that of another one
/// which it shares no node with.
[[nodiscard]] std::vector<bool> passing_edges(const CleanGraph& graph);

}  // namespace dupin::network
