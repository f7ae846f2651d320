#pragma once

#include <vector>

#include "assembly/document_bounds.h"
#include "dupin/blends/pipe_graph.h"

namespace dupin::network {

/// The tolerance of a graph's assembly, where none is given: the least radius has so many.
inline constexpr double kTolerancesInRadius = 25;
/// So that this is one.
inline constexpr double kLeastRadius = kTolerancesInRadius * assembly::kSmallest;

struct Ball {
  std::string name;
  Vec3 center;
  double radius;
  std::size_t line;
};

/// Without loops, double edges, nodes of degree 0, and balls inside of their neighbours.
struct CleanGraph {
  std::vector<Ball> nodes;
  std::vector<GraphEdge> edges;
  std::vector<SourceNote> notes;
};

/// Throws as assembly_of.
[[nodiscard]] CleanGraph cleaned(const PipeGraph& graph, const PipeGraphOptions& options);

}  // namespace dupin::network
