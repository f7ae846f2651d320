#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dupin/blends/junction.h"
#include "dupin/kernel/ring.h"
#include "network/clean_graph.h"

namespace dupin::network {

/// Of a ball, by its node's radius.
constexpr double kBall = 1.1;

/// Of the reason for which a node is left out whose ball was refused; its name follows.
constexpr std::string_view kRefusedBall = "ball ";

/// What a node becomes; those that were merged with others are gone.
enum class NodeKind : std::uint8_t { end, blend, junction, ball, gone };

struct PlannedNode {
  Ball ball;
  NodeKind kind = NodeKind::end;
  bool is_planned = false;
  std::vector<std::size_t> edges = {};
  double hub = 0;  ///< of a junction, its hub's radius
};

struct PlannedEdge {
  GraphEdge ends;
  std::array<double, 2> setbacks{};  ///< how far its pipe or cone is cut back at both nodes
  bool is_left = true;
};

/// Why nothing fitted a node. It is told when one asks for it: that takes several times as long as
/// to find out that nothing does, and most of what is tried is tried silently.
class Misfit {
 public:
  Misfit() = default;
  explicit Misfit(std::string text) : text_(std::move(text)) {}

  [[nodiscard]] std::string text() const;
  /// The edges that were too short for the junction that did not fit, as far as that is known.
  [[nodiscard]] std::vector<std::size_t> too_short() const;

 private:
  friend class GraphPlan;

  std::string text_;  // unless the junction's is to be told
  std::vector<std::size_t> edges_, without_room_;
  std::vector<Ring> ends_;  // of the junction, if there was room
  Vec3 center_ = Vec3::Zero();
};

/// A graph, and what becomes of its nodes, one after the other. Nodes and edges may be changed and
/// planned again; a Snapshot takes changes back.
class GraphPlan {
 public:
  explicit GraphPlan(const CleanGraph& graph);

  [[nodiscard]] const std::vector<PlannedNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<PlannedEdge>& edges() const { return edges_; }
  [[nodiscard]] std::size_t other_end(std::size_t edge, std::size_t node) const;
  [[nodiscard]] double length(std::size_t edge) const;
  [[nodiscard]] std::string edge_name(std::size_t edge) const;
  /// Where the edge's pipe or cone ends that far from the node, its normal to the node.
  [[nodiscard]] Ring ring(std::size_t edge, std::size_t node, double setback) const;

  /// An end, a blend, or a junction; false if none of these fits, and why_not() says why.
  bool plan(std::size_t node);
  /// A ball, which always fits.
  void plan_ball(std::size_t node);
  void unplan(std::size_t node);
  [[nodiscard]] const Misfit& why_not() const { return why_not_; }

  void set_radius(std::size_t node, double radius) { nodes_[node].ball.radius = radius; }
  void move(std::size_t node, const Vec3& center) { nodes_[node].ball.center = center; }
  /// Neither is planned.
  std::size_t add_node(Ball ball);
  std::size_t add_edge(const GraphEdge& edge);
  void lead_to(std::size_t edge, std::size_t before, std::size_t node);
  void remove_edge(std::size_t edge);
  void remove_node(std::size_t node) { nodes_[node].kind = NodeKind::gone; }

  /// Some nodes and all edges there, to be put back. Nodes and edges added since then vanish.
  class Snapshot {
   public:
    Snapshot(const GraphPlan& plan, const std::vector<std::size_t>& nodes);
    void put_back(GraphPlan& plan) const;

   private:
    std::vector<std::pair<std::size_t, PlannedNode>> nodes_;
    std::vector<std::pair<std::size_t, PlannedEdge>> edges_;
    std::size_t node_count_, edge_count_;
  };

 private:
  [[nodiscard]] double& setback(std::size_t edge, std::size_t node);
  [[nodiscard]] double room(std::size_t edge, std::size_t node);
  bool plan_blend(std::size_t node);
  bool plan_junction(std::size_t node);
  [[nodiscard]] std::vector<Ring> junction_ends(std::size_t node,
                                                const std::vector<double>& back) const;

  std::vector<PlannedNode> nodes_;
  std::vector<PlannedEdge> edges_;
  Misfit why_not_;
};

}  // namespace dupin::network
