#pragma once

#include <vector>

#include "dupin/blends/pipe_graph.h"

namespace dupin::network {

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
