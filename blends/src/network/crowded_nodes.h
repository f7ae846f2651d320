#pragma once

#include <map>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "network/graph_plan.h"

namespace dupin::network {

/// Plans every node, those of high degree first. Where nothing smooth fits, the graph is changed:
/// a short edge is contracted, or some of the node's edges are led to a hub of their own beside it
/// ([mathematics A9]: chains of hubs), or the node is made narrower; what depends on that is
/// planned again. Where none of this helps, the node becomes a ball. Each change is noted.
///
/// Nodes that are refused as parts, by "node 7", become balls at once, which is noted as a refusal.
void plan_all(GraphPlan& plan, const std::map<std::string, std::string>& refused,
              std::vector<SourceNote>& notes);

}  // namespace dupin::network
