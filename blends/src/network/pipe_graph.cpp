#include "dupin/blends/pipe_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "dupin/blends/cyclide_blend.h"
#include "dupin/blends/junction.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "network/clean_graph.h"
#include "network/passing_edges.h"

namespace dupin {
namespace {

using network::Ball;
using network::CleanGraph;

// Of an edge that stays straight, and of how it is shared between two nodes that both want more.
constexpr double kLeastStraight = 0.02, kFirstShare = 0.7;
// Of a ball, by the radius of the thickest pipe that runs into it.
constexpr double kBall = 1.1;
// How far from a ball's centre pipes end, by its node's radius, so that no two ends face each other
// at the same place, and by the edge's length.
constexpr double kInBall = 0.3, kInBallOfLength = 0.2;

enum class NodeKind { end, blend, junction, ball };

class Network {
 public:
  Network(const PipeGraph& graph, const PipeGraphOptions& options)
      : clean_(network::cleaned(graph, options)),
        edges_at_(clean_.nodes.size()),
        kinds_(clean_.nodes.size(), NodeKind::end),
        setbacks_(clean_.edges.size(), {0, 0}),
        is_planned_(clean_.nodes.size(), false) {
    result_.assembly.source = graph.source;
    for (std::size_t i = 0; i < clean_.edges.size(); ++i) {
      edges_at_[clean_.edges[i].from].push_back(i);
      edges_at_[clean_.edges[i].to].push_back(i);
    }
    double least = clean_.nodes.front().radius;
    for (const Ball& ball : clean_.nodes) {
      least = std::min(least, ball.radius);
    }
    result_.assembly.tolerance = options.tolerance.value_or(least / 25);
  }

  PipeNetwork run() {
    part_passing_edges();
    std::vector<std::size_t> order(clean_.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{},
                             [&](std::size_t i) { return edges_at_[i].size(); });
    for (const std::size_t node : order) {
      plan(node);
      is_planned_[node] = true;
    }
    add_edges();
    for (std::size_t node = 0; node < clean_.nodes.size(); ++node) {
      add_node(node);
    }
    count();
    result_.notes = std::move(clean_.notes);
    std::ranges::stable_sort(result_.notes, {}, &SourceNote::line);
    return std::move(result_);
  }

 private:
  [[nodiscard]] double& setback(std::size_t edge, std::size_t node) {
    return setbacks_[edge][clean_.edges[edge].from == node ? 0 : 1];
  }

  [[nodiscard]] std::size_t other_end(std::size_t edge, std::size_t node) const {
    const GraphEdge& e = clean_.edges[edge];
    return e.from == node ? e.to : e.from;
  }

  [[nodiscard]] double length(std::size_t edge) const {
    const GraphEdge& e = clean_.edges[edge];
    return (clean_.nodes[e.from].center - clean_.nodes[e.to].center).norm();
  }

  // How far the edge may be cut back here.
  [[nodiscard]] double room(std::size_t edge, std::size_t node) {
    const std::size_t other = other_end(edge, node);
    const double all = (1 - kLeastStraight) * length(edge);
    const bool is_free = edges_at_[other].size() == 1 || kinds_[other] == NodeKind::ball;
    if (is_planned_[other] || is_free) {
      return all - setback(edge, other);
    }
    const bool is_first = edges_at_[node].size() > 2 && edges_at_[other].size() == 2;
    return all * (is_first ? kFirstShare : 0.5);
  }

  // Where the edge's pipe or cone ends that far from the node, its normal to the node.
  [[nodiscard]] Ring ring(std::size_t edge, std::size_t node, double setback) const {
    const Ball &here = clean_.nodes[node], &there = clean_.nodes[other_end(edge, node)];
    const Vec3 along = there.center - here.center;
    const double all = along.norm(), slope = (there.radius - here.radius) / all;
    const Vec3 direction = along / all;
    return {here.center + setback * direction, -direction, here.radius + slope * setback, -slope};
  }

  void part_passing_edges() {
    const std::vector<bool> passing = network::passing_edges(clean_);
    for (std::size_t i = 0; i < passing.size(); ++i) {
      if (!passing[i]) {
        continue;
      }
      for (const std::size_t node : {clean_.edges[i].from, clean_.edges[i].to}) {
        if (edges_at_[node].size() > 1 && kinds_[node] != NodeKind::ball) {
          make_ball(node, "edge " + edge_name(i) + " reaches into one that it is not joined to");
        }
      }
    }
  }

  [[nodiscard]] std::string edge_name(std::size_t edge) const {
    const GraphEdge& e = clean_.edges[edge];
    return clean_.nodes[e.from].name + "-" + clean_.nodes[e.to].name;
  }

  void make_ball(std::size_t node, const std::string& why) {
    kinds_[node] = NodeKind::ball;
    const Ball& ball = clean_.nodes[node];
    for (const std::size_t edge : edges_at_[node]) {
      setback(edge, node) = std::min(kInBall * ball.radius, kInBallOfLength * length(edge));
    }
    clean_.notes.push_back({ball.line, "node " + ball.name + ": a ball of radius " +
                                           decimal(kBall * ball.radius, kMessageDigits) + ", as " +
                                           why});
  }

  void plan(std::size_t node) {
    const std::size_t degree = edges_at_[node].size();
    if (degree == 1 || kinds_[node] == NodeKind::ball) {
      return;
    }
    if (degree == 2 && plan_blend(node)) {
      kinds_[node] = NodeKind::blend;
    } else if (degree > 2 && (plan_junction(node) || plan_narrow_junction(node))) {
      kinds_[node] = NodeKind::junction;
    } else {
      make_ball(node, degree == 2
                          ? "no blend fits between its edges " + edge_name(edges_at_[node][0]) +
                                " and " + edge_name(edges_at_[node][1])
                          : why_not_);
    }
  }

  // Bends of fewer and fewer radii.
  bool plan_blend(std::size_t node) {
    const std::size_t a = edges_at_[node][0], b = edges_at_[node][1];
    const Vec3 u = ring(a, node, 0).normal, v = ring(b, node, 0).normal;
    const double half = std::atan2((u + v).norm(), (u - v).norm());  // of the angle of the turn
    const double most = std::min(room(a, node), room(b, node));
    const double radius = clean_.nodes[node].radius;
    for (const double bend : {4.0, 2.5, 2.0, 1.6, 1.3}) {
      const double back = radius * std::max(bend * std::tan(half), 0.1);
      if (back > most) {
        continue;
      }
      if (search_cyclide_blend(ring(a, node, back), ring(b, node, back)).tube) {
        setback(a, node) = setback(b, node) = back;
        return true;
      }
    }
    return false;
  }

  bool plan_junction(std::size_t node) {
    const std::vector<std::size_t>& edges = edges_at_[node];
    std::vector<double> back;
    back.reserve(edges.size());
    for (const std::size_t edge : edges) {
      back.push_back(room(edge, node));
    }
    JunctionSearch search = searched(node, back);
    if (!search.junction) {
      why_not_ = search.reason;
      return false;
    }
    // Straight pieces are the edges' own, but for some that keeps the search from failing.
    std::vector<double> nearer;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Ring end = ring(edges[i], node, back[i]);
      const double straight = straight_length(search.junction->arms[i]) / std::hypot(1, end.slope);
      nearer.push_back(back[i] - std::max(0.0, straight - end.radius / 16));
    }
    if (searched(node, nearer).junction) {
      back = std::move(nearer);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      setback(edges[i], node) = back[i];
    }
    return true;
  }

  // With less and less of the node's radius, if none of its neighbours relies on that.
  bool plan_narrow_junction(std::size_t node) {
    double& radius = clean_.nodes[node].radius;
    const double before = radius;
    const std::string why_not = why_not_;
    const bool is_free = std::ranges::none_of(
        edges_at_[node], [&](std::size_t edge) { return is_planned_[other_end(edge, node)]; });
    for (const double share : {0.85, 0.7, 0.55, 0.4}) {
      radius = share * before;
      const bool is_nested = std::ranges::any_of(edges_at_[node], [&](std::size_t edge) {
        return clean_.nodes[other_end(edge, node)].radius - radius >= length(edge);
      });
      if (is_free && !is_nested && plan_junction(node)) {
        clean_.notes.push_back(
            {clean_.nodes[node].line, "node " + clean_.nodes[node].name + ": its radius of " +
                                          decimal(before, kMessageDigits) + " made " +
                                          decimal(radius, kMessageDigits) + ", as " + why_not});
        return true;
      }
    }
    radius = before;
    why_not_ = why_not;
    return false;
  }

  [[nodiscard]] JunctionSearch searched(std::size_t node, const std::vector<double>& back) const {
    std::vector<Ring> ends;
    for (std::size_t i = 0; i < back.size(); ++i) {
      if (!(back[i] > 0)) {
        return {{}, "there is no room at edge " + edge_name(edges_at_[node][i]), i, {}};
      }
      ends.push_back(ring(edges_at_[node][i], node, back[i]));
    }
    return search_junction(ends, {.center = clean_.nodes[node].center});
  }

  void add_edges() {
    for (std::size_t i = 0; i < clean_.edges.size(); ++i) {
      const GraphEdge& edge = clean_.edges[i];
      const Ring from = ring(i, edge.from, setbacks_[i][0]), to = ring(i, edge.to, setbacks_[i][1]);
      const std::string name = "edge " + edge_name(i);
      if (clean_.nodes[edge.from].radius == clean_.nodes[edge.to].radius) {
        result_.assembly.parts.push_back(
            {name, PipeBetween{from.center, to.center, clean_.nodes[edge.from].radius}});
      } else {
        result_.assembly.parts.push_back(
            {name, ConeBetween{from.center, to.center, from.radius, to.radius}});
      }
    }
  }

  [[nodiscard]] PortReference port(std::size_t edge, std::size_t node) const {
    return {"edge " + edge_name(edge), clean_.edges[edge].from == node ? End::start : End::end};
  }

  void add_node(std::size_t node) {
    const std::string name = "node " + clean_.nodes[node].name;
    const std::vector<std::size_t>& edges = edges_at_[node];
    if (kinds_[node] == NodeKind::ball) {
      ++result_.balls;
      const Ball& ball = clean_.nodes[node];
      result_.assembly.parts.push_back({name, SphereAt{ball.center, kBall * ball.radius}});
    } else if (kinds_[node] == NodeKind::blend) {
      ++result_.blends;
      result_.assembly.parts.push_back(
          {name, CyclideBlendBetween{port(edges[0], node), port(edges[1], node)}});
    } else if (kinds_[node] == NodeKind::junction) {
      ++result_.junctions;
      JunctionOfPorts junction;
      for (const std::size_t edge : edges) {
        junction.ends.push_back(port(edge, node));
      }
      junction.options.center = clean_.nodes[node].center;
      result_.assembly.parts.push_back({name, std::move(junction)});
    }
  }

  void count() {
    result_.nodes = clean_.nodes.size();
    result_.edges = clean_.edges.size();
    std::vector<bool> is_seen(result_.nodes, false);
    for (std::size_t first = 0; first < result_.nodes; ++first) {
      if (is_seen[first]) {
        continue;
      }
      ++result_.components;
      std::vector<std::size_t> stack{first};
      is_seen[first] = true;
      while (!stack.empty()) {
        const std::size_t node = stack.back();
        stack.pop_back();
        for (const std::size_t edge : edges_at_[node]) {
          const std::size_t other = other_end(edge, node);
          if (!is_seen[other]) {
            is_seen[other] = true;
            stack.push_back(other);
          }
        }
      }
    }
    result_.cycles = result_.edges + result_.components - result_.nodes;
    if (result_.components > 1) {
      clean_.notes.push_back({0, "the graph has " + std::to_string(result_.components) +
                                     " parts that are not joined"});
    }
  }

  CleanGraph clean_;
  std::vector<std::vector<std::size_t>> edges_at_;
  std::vector<NodeKind> kinds_;
  std::vector<std::array<double, 2>> setbacks_;  // of edges, at both nodes
  std::vector<bool> is_planned_;
  std::string why_not_;
  PipeNetwork result_;
};

}  // namespace

PipeNetwork assembly_of(const PipeGraph& graph, const PipeGraphOptions& options) {
  if (options.radius && !(*options.radius > 0 && *options.radius <= 1e12)) {
    throw Error(Errc::invalid_argument,
                "the radius of nodes must be positive and at most 1e12, not " +
                    decimal(*options.radius, kMessageDigits));
  }
  return Network(graph, options).run();
}

}  // namespace dupin
