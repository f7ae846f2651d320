
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "network/crowded_nodes.h"

namespace dupin::network {
namespace {

using testing::HasSubstr;

CleanGraph graph_of(const std::vector<Vec3>& places, std::vector<GraphEdge> edges,
                    double radius = 1) {
  CleanGraph graph;
  for (const Vec3& at : places) {
    graph.nodes.push_back({std::to_string(graph.nodes.size()), at, radius, graph.nodes.size() + 1});
  }
  graph.edges = std::move(edges);
  return graph;
}

struct Planned {
  GraphPlan plan;
  std::vector<SourceNote> notes;
};

Planned planned(const CleanGraph& graph, const std::map<std::string, std::string>& refused = {}) {
  Planned result{GraphPlan(graph), {}};
  plan_all(result.plan, refused, result.notes);
  return result;
}

std::size_t count(const GraphPlan& plan, NodeKind kind) {
  return std::size_t(std::ranges::count(plan.nodes(), kind, &PlannedNode::kind));
}

// Cycles and components do not change.
std::ptrdiff_t nodes_less_edges(const GraphPlan& plan) {
  return std::ptrdiff_t(plan.nodes().size() - count(plan, NodeKind::gone)) -
         std::ranges::count(plan.edges(), true, &PlannedEdge::is_left);
}

TEST(CrowdedNodes, edges_shorter_than_their_setbacks_are_contracted) {
  const CleanGraph graph =
      graph_of({{0, 0, 0}, {1.2, 0, 0}, {-20, 12, 0}, {-20, -12, 0}, {20, 12, 0}, {20, -12, 0}},
               {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}});
  const auto [plan, notes] = planned(graph);
  EXPECT_EQ(count(plan, NodeKind::junction), 1);
  EXPECT_EQ(count(plan, NodeKind::gone), 1);
  EXPECT_EQ(count(plan, NodeKind::ball), 0);
  EXPECT_EQ(nodes_less_edges(plan), 1);
  ASSERT_EQ(notes.size(), 1);
  EXPECT_THAT(notes[0].text, HasSubstr("edge 0-1: of length 1.2, too short for what its nodes "
                                       "need, contracted: node "));
}

// To contract one of its edges would close a hole.
TEST(CrowdedNodes, triangles_are_not_contracted) {
  const CleanGraph graph = graph_of({{0, 0, 0}, {1.5, 0, 0}, {0.7, 1.4, 0}, {-20, -10, 0}},
                                    {{0, 1}, {1, 2}, {2, 0}, {0, 3}});
  const auto [plan, notes] = planned(graph);
  EXPECT_EQ(count(plan, NodeKind::gone), 0);
  EXPECT_EQ(nodes_less_edges(plan), 0);
}

TEST(CrowdedNodes, refused_nodes_become_balls_and_say_so) {
  const CleanGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {40, 20, 0}}, {{0, 1}, {1, 2}});
  const auto [plan, notes] = planned(graph, {{"node 1", "it folds"}});
  EXPECT_EQ(plan.nodes()[1].kind, NodeKind::ball);
  ASSERT_EQ(notes.size(), 1);
  EXPECT_TRUE(notes[0].is_refusal);
  EXPECT_EQ(notes[0].text, "node 1: a ball of radius 1.1, as it folds");
}

}  // namespace
}  // namespace dupin::network
