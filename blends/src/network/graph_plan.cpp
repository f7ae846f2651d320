#include "network/graph_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dupin/blends/cyclide_blend.h"
#include "junction/hub_search.h"

namespace dupin::network {
namespace {

std::optional<Junction> hub_about(const Vec3& center, const std::vector<Ring>& ends) {
  return junction::find_hub(junction::approaches_of(ends), center, {});
}

// Of an edge that stays straight, and of how it is shared between two nodes that both want more.
constexpr double kLeastStraight = 0.02, kFirstShare = 0.7;
// How far from a ball's centre pipes end, by its node's radius, so that no two ends face each other
// at the same place, and by the edge's length.
constexpr double kInBall = 0.3, kInBallOfLength = 0.2;

// Whether edges that leave a node to one side overlap where a blend would begin, but for a
// sixteenth of their radii: what the blend leads back along would be in its own way.
bool overlap(const Ring& a, const Ring& b) {
  constexpr double kApart = 17. / 16;
  return a.normal.dot(b.normal) > 0 &&
         (a.center - b.center).norm() < kApart * (a.radius + b.radius);
}

}  // namespace

GraphPlan::GraphPlan(const CleanGraph& graph) {
  for (const Ball& ball : graph.nodes) {
    add_node(ball);
  }
  for (const GraphEdge& edge : graph.edges) {
    add_edge(edge);
  }
}

std::size_t GraphPlan::other_end(std::size_t edge, std::size_t node) const {
  const GraphEdge& ends = edges_[edge].ends;
  return ends.from == node ? ends.to : ends.from;
}

double GraphPlan::length(std::size_t edge) const {
  const GraphEdge& ends = edges_[edge].ends;
  return (nodes_[ends.from].ball.center - nodes_[ends.to].ball.center).norm();
}

std::string GraphPlan::edge_name(std::size_t edge) const {
  const GraphEdge& ends = edges_[edge].ends;
  return nodes_[ends.from].ball.name + "-" + nodes_[ends.to].ball.name;
}

Ring GraphPlan::ring(std::size_t edge, std::size_t node, double setback) const {
  const Ball &here = nodes_[node].ball, &there = nodes_[other_end(edge, node)].ball;
  const Vec3 along = there.center - here.center;
  const double all = along.norm(), slope = (there.radius - here.radius) / all;
  const Vec3 direction = along / all;
  return {here.center + setback * direction, -direction, here.radius + slope * setback, -slope};
}

double& GraphPlan::setback(std::size_t edge, std::size_t node) {
  PlannedEdge& planned = edges_[edge];
  return planned.setbacks.at(planned.ends.from == node ? 0 : 1);
}

// How far the edge may be cut back here.
double GraphPlan::room(std::size_t edge, std::size_t node) {
  const std::size_t other = other_end(edge, node);
  const PlannedNode& there = nodes_[other];
  const double all = (1 - kLeastStraight) * length(edge);
  if (there.is_planned || there.edges.size() == 1) {
    return all - setback(edge, other);
  }
  const bool is_first = nodes_[node].edges.size() > 2 && there.edges.size() == 2;
  return all * (is_first ? kFirstShare : 0.5);
}

bool GraphPlan::plan(std::size_t node) {
  PlannedNode& planned = nodes_[node];
  const std::vector<std::size_t>& edges = planned.edges;
  why_not_ = {};
  if (edges.size() < 2) {
    planned.kind = NodeKind::end;
  } else if (edges.size() == 2 && plan_blend(node)) {
    planned.kind = NodeKind::blend;
  } else if (plan_junction(node)) {
    planned.kind = NodeKind::junction;
  } else {
    if (edges.size() == 2) {
      why_not_.text_ =
          "no blend fits between its edges " + edge_name(edges[0]) + " and " + edge_name(edges[1]);
    }
    return false;
  }
  planned.is_planned = true;
  return true;
}

void GraphPlan::plan_ball(std::size_t node) {
  PlannedNode& planned = nodes_[node];
  planned.kind = NodeKind::ball;
  planned.is_planned = true;
  for (const std::size_t edge : planned.edges) {
    setback(edge, node) = std::min(kInBall * planned.ball.radius, kInBallOfLength * length(edge));
  }
}

void GraphPlan::unplan(std::size_t node) {
  nodes_[node].is_planned = false;
  for (const std::size_t edge : nodes_[node].edges) {
    setback(edge, node) = 0;
  }
}

std::size_t GraphPlan::add_node(Ball ball) {
  nodes_.push_back({std::move(ball)});
  return nodes_.size() - 1;
}

std::size_t GraphPlan::add_edge(const GraphEdge& edge) {
  nodes_[edge.from].edges.push_back(edges_.size());
  nodes_[edge.to].edges.push_back(edges_.size());
  edges_.push_back({edge});
  return edges_.size() - 1;
}

void GraphPlan::lead_to(std::size_t edge, std::size_t before, std::size_t node) {
  std::erase(nodes_[before].edges, edge);
  nodes_[node].edges.push_back(edge);
  setback(edge, before) = 0;
  GraphEdge& ends = edges_[edge].ends;
  (ends.from == before ? ends.from : ends.to) = node;
}

void GraphPlan::remove_edge(std::size_t edge) {
  std::erase(nodes_[edges_[edge].ends.from].edges, edge);
  std::erase(nodes_[edges_[edge].ends.to].edges, edge);
  edges_[edge].is_left = false;
}

GraphPlan::Snapshot::Snapshot(const GraphPlan& plan, const std::vector<std::size_t>& nodes)
    : node_count_(plan.nodes_.size()), edge_count_(plan.edges_.size()) {
  for (const std::size_t node : nodes) {
    nodes_.emplace_back(node, plan.nodes_[node]);
    for (const std::size_t edge : plan.nodes_[node].edges) {
      edges_.emplace_back(edge, plan.edges_[edge]);
    }
  }
}

void GraphPlan::Snapshot::put_back(GraphPlan& plan) const {
  plan.nodes_.resize(node_count_);
  plan.edges_.resize(edge_count_);
  for (const auto& [node, before] : nodes_) {
    plan.nodes_[node] = before;
  }
  for (const auto& [edge, before] : edges_) {
    plan.edges_[edge] = before;
  }
}

// Bends of fewer and fewer radii.
bool GraphPlan::plan_blend(std::size_t node) {
  const std::size_t a = nodes_[node].edges[0], b = nodes_[node].edges[1];
  const Vec3 u = ring(a, node, 0).normal, v = ring(b, node, 0).normal;
  const double half = std::atan2((u + v).norm(), (u - v).norm());  // of the angle of the turn
  const double most = std::min(room(a, node), room(b, node));
  const double radius = nodes_[node].ball.radius;
  for (const double bend : {4.0, 2.5, 2.0, 1.6, 1.3}) {
    const double back = radius * std::max(bend * std::tan(half), 0.1);
    if (back > most) {
      continue;
    }
    const Ring from = ring(a, node, back), to = ring(b, node, back);
    if (!overlap(from, to) && search_cyclide_blend(from, to).tube) {
      setback(a, node) = setback(b, node) = back;
      return true;
    }
  }
  return false;
}

bool GraphPlan::plan_junction(std::size_t node) {
  const std::vector<std::size_t>& edges = nodes_[node].edges;
  std::vector<double> back;
  back.reserve(edges.size());
  for (const std::size_t edge : edges) {
    back.push_back(room(edge, node));
  }
  const Vec3& center = nodes_[node].ball.center;
  why_not_.edges_ = edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!(back[i] > 0)) {
      why_not_.without_room_.push_back(edges[i]);
    }
  }
  if (!why_not_.without_room_.empty()) {
    why_not_.text_ = "there is no room at edge " + edge_name(why_not_.without_room_.front());
    return false;
  }
  why_not_.ends_ = junction_ends(node, back);
  why_not_.center_ = center;
  auto junction = hub_about(center, why_not_.ends_);
  if (!junction) {
    return false;
  }
  // Straight pieces are the edges' own, but for some that keeps the search from failing.
  std::vector<double> nearer;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Ring end = ring(edges[i], node, back[i]);
    const double straight = straight_length(junction->arms[i]) / std::hypot(1, end.slope);
    nearer.push_back(back[i] - std::max(0.0, straight - end.radius / 16));
  }
  const bool is_room = std::ranges::all_of(nearer, [](double length) { return length > 0; });
  if (const auto shorter =
          is_room ? hub_about(center, junction_ends(node, nearer)) : std::nullopt) {
    back = std::move(nearer);
    junction = shorter;
  }
  nodes_[node].hub = junction->hub.radius;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    setback(edges[i], node) = back[i];
  }
  return true;
}

std::vector<Ring> GraphPlan::junction_ends(std::size_t node,
                                           const std::vector<double>& back) const {
  std::vector<Ring> ends;
  for (std::size_t i = 0; i < back.size(); ++i) {
    ends.push_back(ring(nodes_[node].edges[i], node, back[i]));
  }
  return ends;
}

std::string Misfit::text() const {
  return text_.empty() && !ends_.empty() ? search_junction(ends_, {.center = center_}).reason
                                         : text_;
}

std::vector<std::size_t> Misfit::too_short() const {
  std::vector<std::size_t> result = without_room_;
  if (!ends_.empty()) {
    const JunctionSearch search = search_junction(ends_, {.center = center_});
    for (std::size_t i = 0; i < search.setbacks.size(); ++i) {
      if (search.setbacks[i] > 0) {
        result.push_back(edges_[i]);
      }
    }
  }
  return result;
}

}  // namespace dupin::network
