#include <algorithm>
#include <cmath>
#include <utility>

#include "assembly/document_bounds.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "network/clean_graph.h"
#include "network/crowded_nodes.h"
#include "network/graph_plan.h"
#include "network/passing_edges.h"

namespace dupin {
namespace {

using network::Ball;
using network::CleanGraph;
using network::GraphPlan;
using network::NodeKind;
using network::PlannedEdge;
using network::PlannedNode;

// The parts of a planned graph.
class Network {
 public:
  Network(const GraphPlan& plan, PipeNetwork& result) : plan_(plan), result_(result) {}

  void run() {
    for (std::size_t i = 0; i < plan_.edges().size(); ++i) {
      if (plan_.edges()[i].is_left) {
        ++result_.edges;
        add_edge(i);
      }
    }
    for (std::size_t node = 0; node < plan_.nodes().size(); ++node) {
      if (plan_.nodes()[node].kind != NodeKind::gone) {
        ++result_.nodes;
        add_node(node);
      }
    }
    count_components();
    for (const auto& [one, other] : network::passing_edges(plan_)) {
      result_.notes.push_back({plan_.edges()[other].ends.line,
                               "edge " + plan_.edge_name(other) + ": passes through edge " +
                                   plan_.edge_name(one) + ", to which it is not joined; united"});
    }
    for (const auto& [node, edge, other] : network::passing_nodes(plan_)) {
      const Ball& ball = plan_.nodes()[node].ball;
      const std::string through =
          edge ? "edge " + plan_.edge_name(*edge) : "node " + plan_.nodes()[other].ball.name;
      result_.notes.push_back({ball.line, "node " + ball.name + ": passes through " + through +
                                              ", to which it is not joined; united"});
    }
  }

 private:
  void add_edge(std::size_t edge) {
    const auto& [ends, setbacks, is_left] = plan_.edges()[edge];
    const Ring from = plan_.ring(edge, ends.from, setbacks[0]),
               to = plan_.ring(edge, ends.to, setbacks[1]);
    const double radius = plan_.nodes()[ends.from].ball.radius;
    const std::string name = "edge " + plan_.edge_name(edge);
    if (radius == plan_.nodes()[ends.to].ball.radius) {
      result_.assembly.parts.push_back({name, PipeBetween{from.center, to.center, radius}});
    } else {
      result_.assembly.parts.push_back(
          {name, ConeBetween{from.center, to.center, from.radius, to.radius}});
    }
  }

  [[nodiscard]] PortReference port(std::size_t edge, std::size_t node) const {
    return {"edge " + plan_.edge_name(edge),
            plan_.edges()[edge].ends.from == node ? End::start : End::end};
  }

  void add_node(std::size_t node) {
    const auto& [ball, kind, is_planned, edges, hub] = plan_.nodes()[node];
    const std::string name = "node " + ball.name;
    if (kind == NodeKind::ball) {
      ++result_.balls;
      result_.assembly.parts.push_back({name, SphereAt{ball.center, network::kBall * ball.radius}});
    } else if (kind == NodeKind::blend) {
      ++result_.blends;
      result_.assembly.parts.push_back(
          {name, CyclideBlendBetween{port(edges[0], node), port(edges[1], node)}});
    } else if (kind == NodeKind::junction) {
      ++result_.junctions;
      JunctionOfPorts junction;
      for (const std::size_t edge : edges) {
        junction.ends.push_back(port(edge, node));
      }
      junction.options.center = ball.center;
      result_.assembly.parts.push_back({name, std::move(junction)});
    }
  }

  void count_components() {
    std::vector<bool> is_seen(plan_.nodes().size(), false);
    for (std::size_t first = 0; first < is_seen.size(); ++first) {
      if (is_seen[first] || plan_.nodes()[first].kind == NodeKind::gone) {
        continue;
      }
      ++result_.components;
      std::vector<std::size_t> stack{first};
      is_seen[first] = true;
      while (!stack.empty()) {
        const std::size_t node = stack.back();
        stack.pop_back();
        for (const std::size_t edge : plan_.nodes()[node].edges) {
          const std::size_t other = plan_.other_end(edge, node);
          if (!is_seen[other]) {
            is_seen[other] = true;
            stack.push_back(other);
          }
        }
      }
    }
    result_.cycles = result_.edges + result_.components - result_.nodes;
    if (result_.components > 1) {
      result_.notes.push_back({0, "the graph has " + std::to_string(result_.components) +
                                      " parts that are not joined"});
    }
  }

  const GraphPlan& plan_;
  PipeNetwork& result_;
};

void leave_out_refused(GraphPlan& plan, const std::map<std::string, std::string>& refused,
                       std::vector<SourceNote>& notes) {
  for (std::size_t i = 0; i < plan.edges().size() && !refused.empty(); ++i) {
    const std::string name = "edge " + plan.edge_name(i);
    if (const auto found = refused.find(name); found != refused.end()) {
      notes.push_back(
          {plan.edges()[i].ends.line, name + ": " + found->second + "; left out", true});
      plan.remove_edge(i);
    }
  }
  for (std::size_t node = 0; node < plan.nodes().size() && !refused.empty(); ++node) {
    const Ball& ball = plan.nodes()[node].ball;
    const auto found = refused.find(std::string(network::kRefusedBall) + ball.name);
    if (found != refused.end()) {
      notes.push_back({ball.line,
                       "node " + ball.name + ": " + found->second + "; left out with its edges",
                       true});
      for (const std::size_t edge : std::vector(plan.nodes()[node].edges)) {
        plan.remove_edge(edge);
      }
    }
  }
  for (std::size_t node = 0; node < plan.nodes().size(); ++node) {
    if (plan.nodes()[node].edges.empty()) {
      plan.remove_node(node);
    }
  }
}

}  // namespace

PipeNetwork assembly_of(const PipeGraph& graph, const PipeGraphOptions& options) {
  if (options.radius &&
      !(*options.radius >= network::kLeastRadius && *options.radius <= assembly::kLargest)) {
    throw Error(Errc::invalid_argument, "the radius of nodes must be between " +
                                            decimal(network::kLeastRadius, kMessageDigits) +
                                            " and 1e12, not " +
                                            decimal(*options.radius, kMessageDigits));
  }
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance))) {
    throw Error(Errc::invalid_argument, "the tolerance must be positive and finite, not " +
                                            decimal(*options.tolerance, kMessageDigits));
  }
  CleanGraph clean = network::cleaned(graph, options);
  PipeNetwork result;
  result.assembly.source = graph.source;
  result.assembly.is_of_network = true;
  result.assembly.unit = options.unit;
  const auto least = std::ranges::min_element(clean.nodes, {}, &Ball::radius);
  result.assembly.tolerance =
      options.tolerance.value_or(least->radius / network::kTolerancesInRadius);
  result.notes = graph.notes;
  result.notes.insert(result.notes.end(), clean.notes.begin(), clean.notes.end());
  GraphPlan plan(clean);
  leave_out_refused(plan, options.refused, result.notes);
  network::plan_all(plan, options.refused, result.notes);
  Network(plan, result).run();
  if (result.assembly.parts.empty()) {
    throw Error(Errc::invalid_argument, "of the graph, no edge is left that could be built", {},
                graph.source);
  }
  std::ranges::stable_sort(result.notes, {}, &SourceNote::line);
  return result;
}

}  // namespace dupin
