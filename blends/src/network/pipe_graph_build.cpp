#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "dupin/blends/pipe_graph.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "network/graph_plan.h"
#include "network/part_fault.h"

namespace dupin {
namespace {

// The node or edge of the part that an error names; an arm is its node's. Empty if none.
std::string named_part(const PipeNetwork& network, const Error& error) {
  const std::string part = network::named_part(error);
  std::string name = part.substr(0, part.find('.'));
  const bool is_known = std::ranges::count(network.assembly.parts, name, &Part::name) > 0;
  return is_known ? name : std::string();
}

// What may be done about a part, one after the other: the edge is left out or the node becomes a
// ball; then so does the node that it was made for; then that is left out.
std::array<std::string, 3> remedies(const std::string& part) {
  const std::size_t begin = part.find(' ') + 1;
  const std::string node = part.substr(begin, part.find_first_of("-+", begin) - begin);
  return {part, "node " + node, std::string(network::kRefusedBall) + node};
}

// Of the node or edge that the part is made of; 0 if there is none.
std::size_t line_of(const PipeGraph& graph, const std::string& part) {
  const auto name = [&](std::size_t node) { return graph.nodes.at(node).name; };
  const auto is_the_edge = [&](const GraphEdge& edge) {
    return edge.from < graph.nodes.size() && edge.to < graph.nodes.size() &&
           part == "edge " + name(edge.from) + "-" + name(edge.to);
  };
  if (const auto edge = std::ranges::find_if(graph.edges, is_the_edge); edge != graph.edges.end()) {
    return edge->line;
  }
  const std::string node = remedies(part)[1];
  const auto is_the_node = [&](const GraphNode& one) { return node == "node " + one.name; };
  const auto found = std::ranges::find_if(graph.nodes, is_the_node);
  return found == graph.nodes.end() ? 0 : found->line;
}

// The error with the line as its place, instead of one in a document that nobody wrote.
Error at_line(const Error& error, const PipeGraph& graph, const std::string& part,
              bool keep_going) {
  const std::size_t line = part.empty() ? 0 : line_of(graph, part);
  const bool is_left_out = !keep_going && network::is_of_part(error.code());
  return line == 0 ? error
                   : Error(error.code(),
                           error.message() + (is_left_out ? "; --keep-going does without it" : ""),
                           error.part(), graph.source + ":" + std::to_string(line));
}

// Whether there was one that has not been tried.
bool refuse(const std::string& part, const std::string& why,
            std::map<std::string, std::string>& refused) {
  return std::ranges::any_of(remedies(part), [&](const std::string& remedy) {
    return refused.emplace(remedy, why).second;
  });
}

}  // namespace

Built build(const PipeGraph& graph, const PipeGraphOptions& options, PipeNetwork& network,
            const BuildOptions& build_options) {
  const UsualArithmetic usual;
  PipeGraphOptions fewer = options;
  for (int round = 0;; ++round) {
    try {
      return build(network.assembly, build_options);
    } catch (const Error& error) {
      const std::string part = named_part(network, error);
      if (!options.keep_going || part.empty() || !network::is_of_part(error.code()) ||
          round == network::kMostRounds || !refuse(part, error.message(), fewer.refused)) {
        throw at_line(error, graph, part, options.keep_going);
      }
    }
    const Assembly given = std::move(network.assembly);
    network = assembly_of(graph, fewer);
    network.assembly.wall = given.wall;
    network.assembly.wall_side = given.wall_side;
    network.assembly.insulation = given.insulation;
  }
}

}  // namespace dupin
