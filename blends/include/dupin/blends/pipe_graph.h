#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A point where pipes meet, as the file has it.
struct GraphNode {
  std::string name;  ///< its number in the file
  Vec3 center = Vec3::Zero();
  std::optional<double> radius = {};  ///< none: the file gives none
  std::size_t line = 0;               ///< of the file, from 1; 0 if there is none
};

struct GraphEdge {
  std::size_t from = 0, to = 0;  ///< positions in PipeGraph::nodes
  std::size_t line = 0;
};

/// A graph with balls for nodes, as it was read: it may hold whatever `assembly_of` cleans.
struct PipeGraph {
  std::string source;  ///< the file's name, for messages; may be empty
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
  std::vector<SourceNote> notes = {};  ///< of what was left out when it was read
};

struct PipeGraphOptions {
  std::optional<double> radius = {};     ///< of nodes whose own is missing or not positive
  std::optional<double> tolerance = {};  ///< none: a 25th of the least radius
  bool keep_going = false;       ///< nodes and edges that are refused are left out, and noted
  Unit unit = Unit::millimetre;  ///< of the graph's numbers and these
  /// Parts that a build refused, by their names, and why: such nodes become balls, such edges are
  /// left out, and so are nodes, with their edges, whose "ball NAME" is refused.
  std::map<std::string, std::string> refused = {};
};

/// The assembly of a graph, and what became of the graph on the way.
struct PipeNetwork {
  Assembly assembly;
  std::vector<SourceNote> notes;     ///< by line
  std::size_t nodes = 0, edges = 0;  ///< that are left after cleaning
  std::size_t components = 0;
  std::size_t cycles = 0;  ///< the first Betti number, edges - nodes + components
  std::size_t blends = 0, junctions = 0, balls = 0;  ///< nodes by what they became
};

/// Every edge becomes a pipe or cone, every node of degree 2 a cyclide blend and of more a
/// junction, where these fit; else a ball that the pipes run into (docs/graphs.md has the rules).
/// Edges that pass through others that they do not share a node with end in balls, too, so that
/// the exact union is what joins them.
///
/// Throws Error{invalid_argument} with "file:line" for a node without a radius or a number that is
/// not finite, unless told to keep going, for a graph of which no edge is left, and for options out
/// of range. Takes
/// O(n log n + k) time for k pairs of edges whose boxes overlap along x, and a search for each
/// node.
[[nodiscard]] PipeNetwork assembly_of(const PipeGraph& graph, const PipeGraphOptions& options = {});

/// Builds the network's assembly. Where told to keep going, a part that is refused is replaced as
/// PipeGraphOptions::refused says, noted, and the rest is built; the network is then that one.
/// Throws as `build` for what else is refused.
[[nodiscard]] Built build(const PipeGraph& graph, const PipeGraphOptions& options,
                          PipeNetwork& network, const BuildOptions& build_options = {});

}  // namespace dupin
