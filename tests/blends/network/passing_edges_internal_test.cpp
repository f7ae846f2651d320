#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "network/passing_edges.h"

namespace dupin::network {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Pair = std::array<std::size_t, 2>;

CleanGraph graph_of(const std::vector<std::pair<Vec3, double>>& balls,
                    std::vector<GraphEdge> edges) {
  CleanGraph graph;
  for (const auto& [center, radius] : balls) {
    graph.nodes.push_back({std::to_string(graph.nodes.size()), center, radius, 0});
  }
  graph.edges = std::move(edges);
  return graph;
}

TEST(PassingEdges, are_those_whose_pipes_meet_unless_they_share_a_node) {
  const auto with_radius = [](double r) {
    return GraphPlan(graph_of({{{-5, 0, 0}, r},
                               {{5, 0, 0}, r},
                               {{0, -5, 1.5}, r},
                               {{0, 5, 1.5}, r},
                               {{0, -5, 9}, r},
                               {{5, 9, 0}, r}},
                              {{0, 1}, {2, 3}, {2, 4}, {1, 5}}));
  };
  EXPECT_THAT(passing_edges(with_radius(1)), ElementsAre(Pair{0, 1}));
  EXPECT_TRUE(pass(with_radius(1), 1, 0));
  EXPECT_THAT(passing_edges(with_radius(0.7)), IsEmpty());
}

// Capsules of the larger radius would meet.
TEST(PassingEdges, are_told_by_the_radii_where_they_come_near) {
  const auto beside = [](double height) {
    return GraphPlan(graph_of(
        {{{0, 0, 0}, 3}, {{20, 0, 0}, 0.5}, {{18, -9, height}, 0.5}, {{18, 9, height}, 0.5}},
        {{0, 1}, {2, 3}}));
  };
  EXPECT_THAT(passing_edges(beside(1.5)), IsEmpty());
  EXPECT_THAT(passing_edges(beside(1.2)), ElementsAre(Pair{0, 1}));
}

TEST(PassingNodes, are_hubs_arms_balls_and_bends_that_meet_edges_or_each_other) {
  const auto planned = [](double height, NodeKind kind) {
    std::vector<GraphEdge> edges{{0, 1}, {0, 2}, {4, 5}};
    if (kind != NodeKind::blend) {
      edges.push_back({0, 3});
    }
    GraphPlan plan(graph_of({{{0, 0, 0}, 1},
                             {{20, 0, 0}, 1},
                             {{-10, 17, 0}, 1},
                             {{-10, -17, 0}, 1},
                             {{-.5, -30, height}, 1},
                             {{-.5, 30, height}, 1}},
                            edges));
    if (kind == NodeKind::ball) {
      plan.plan_ball(0);
    } else {
      EXPECT_TRUE(plan.plan(0));
    }
    EXPECT_EQ(plan.nodes()[0].kind, kind);
    return plan;
  };
  for (const NodeKind kind : {NodeKind::junction, NodeKind::ball}) {
    const auto near = passing_nodes(planned(1.9, kind));
    ASSERT_EQ(near.size(), 1);
    EXPECT_EQ(near[0], (PassingNode{0, 2, 0}));
    EXPECT_THAT(passing_nodes(planned(4, kind)), IsEmpty());
  }
  const auto bend = planned(1.9, NodeKind::blend);
  EXPECT_THAT(passing_nodes(bend), testing::Contains(PassingNode{0, 2, 0}));
  EXPECT_THAT(passing_nodes(planned(4, NodeKind::blend)), IsEmpty());
}

TEST(PassingNodes, are_not_those_that_an_edge_joins) {
  GraphPlan plan(graph_of({{{0, 0, 0}, 1},
                           {{20, 0, 0}, 1},
                           {{-10, 17, 0}, 1},
                           {{-10, -17, 0}, 1},
                           {{30, 17, 0}, 1},
                           {{30, -17, 0}, 1}},
                          {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}}));
  ASSERT_TRUE(plan.plan(0));
  ASSERT_TRUE(plan.plan(1));
  EXPECT_THAT(passing_nodes(plan), IsEmpty());
  EXPECT_THAT(passing_edges(plan), IsEmpty());
}

TEST(PassingEdges, end_where_they_are_cut_back) {
  GraphPlan plan(
      graph_of({{{0, 0, 0}, 1}, {{9, 0, 0}, 1}, {{18, 0, 0}, 1}, {{9, 2.5, 0}, 1}, {{9, 20, 0}, 1}},
               {{0, 1}, {1, 2}, {3, 4}}));
  ASSERT_TRUE(plan.plan(1));
  EXPECT_THAT(passing_edges(plan), IsEmpty());
}

}  // namespace
}  // namespace dupin::network
