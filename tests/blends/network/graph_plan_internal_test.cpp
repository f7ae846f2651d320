#include <gtest/gtest.h>

#include "network/graph_plan.h"

namespace dupin::network {
namespace {

// Three pipes that meet in node 0, the third with a bend.
GraphPlan three_ways(double length = 10) {
  CleanGraph graph;
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(length, 0, 0), Vec3(0, length, 0),
                         Vec3(-length, -length, 0), Vec3(-length, -2 * length, 0)}) {
    graph.nodes.push_back({std::to_string(graph.nodes.size()), at, 1, 0});
  }
  graph.edges = {{0, 1}, {2, 0}, {0, 3}, {3, 4}};
  return GraphPlan(graph);
}

TEST(GraphPlan, nodes_become_what_fits) {
  GraphPlan plan = three_ways();
  for (const std::size_t node : {0U, 1U, 2U, 3U, 4U}) {
    EXPECT_TRUE(plan.plan(node));
  }
  EXPECT_EQ(plan.nodes()[0].kind, NodeKind::junction);
  EXPECT_EQ(plan.nodes()[1].kind, NodeKind::end);
  EXPECT_EQ(plan.nodes()[3].kind, NodeKind::blend);
  EXPECT_GT(plan.edges()[1].setbacks[1], 1);
  EXPECT_EQ(plan.edges()[1].setbacks[0], 0);
  EXPECT_LT(plan.edges()[2].setbacks[0] + plan.edges()[2].setbacks[1], plan.length(2));
  EXPECT_EQ(plan.edge_name(1), "2-0");
  const Ring ring = plan.ring(0, 0, 2);
  EXPECT_EQ(ring.center, Vec3(2, 0, 0));
  EXPECT_EQ(ring.normal, Vec3(-1, 0, 0));
}

TEST(GraphPlan, nothing_fits_where_there_is_no_room_but_a_ball) {
  GraphPlan plan = three_ways(1.2);
  EXPECT_FALSE(plan.plan(0));
  EXPECT_NE(plan.why_not().text(), "");
  EXPECT_EQ(plan.why_not().too_short().size(), 3U);
  EXPECT_FALSE(plan.nodes()[0].is_planned);
  plan.plan_ball(0);
  EXPECT_EQ(plan.nodes()[0].kind, NodeKind::ball);
  EXPECT_GT(plan.edges()[0].setbacks[0], 0);
}

// A bend of half a turn or nearly so is none for a blend of few radii, but two caps of a ball.
TEST(GraphPlan, sharp_bends_become_junctions_of_two) {
  CleanGraph graph;
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(14, 3, 0), Vec3(14, -3, 0)}) {
    graph.nodes.push_back({std::to_string(graph.nodes.size()), at, 1, 0});
  }
  graph.edges = {{0, 1}, {0, 2}};
  GraphPlan plan(graph);
  ASSERT_TRUE(plan.plan(0)) << plan.why_not().text();
  EXPECT_NE(plan.nodes()[0].kind, NodeKind::ball);
}

// Two cones that leave a node side by side, widening: where they overlap, a blend from one to the
// other would cross itself.
TEST(GraphPlan, blends_do_not_begin_where_their_edges_overlap) {
  int blends = 0, others = 0;
  for (int i = 0; i < 40; ++i) {
    CleanGraph graph;
    graph.nodes = {{"0", {22.19, 41.91, 5.78}, 0.4 + 0.02 * i, 0},
                   {"2", {6.44, 7.47, 9.21}, 1.3, 0},
                   {"4", {9.94, 16.52, 4.62}, 1.486, 0},
                   {"3", {58.69, 16.32, 10.91}, 1, 0}};
    graph.edges = {{0, 1}, {0, 2}, {2, 3}};
    GraphPlan plan(graph);
    if (!plan.plan(2) || !plan.plan(0) || plan.nodes()[0].kind != NodeKind::blend) {
      ++others;
      continue;
    }
    ++blends;
    const Ring a = plan.ring(0, 0, plan.edges()[0].setbacks[0]),
               b = plan.ring(1, 0, plan.edges()[1].setbacks[0]);
    EXPECT_GT((a.center - b.center).norm(), a.radius + b.radius) << i;
  }
  EXPECT_GT(blends, 0);
  EXPECT_GT(others, 0);
}

TEST(GraphPlan, changes_are_taken_back) {
  GraphPlan plan = three_ways();
  ASSERT_TRUE(plan.plan(0));
  const auto nodes = plan.nodes().size(), edges = plan.edges().size();
  const auto setbacks = plan.edges()[0].setbacks;
  const GraphPlan::Snapshot before(plan, {0, 1, 2, 3});
  plan.unplan(0);
  const std::size_t hub = plan.add_node({"0+1", {3, 3, 0}, 1, 0});
  plan.add_edge({0, hub});
  plan.lead_to(0, 0, hub);
  plan.remove_edge(2);
  EXPECT_EQ(plan.other_end(0, 1), hub);
  EXPECT_EQ(plan.nodes()[0].edges.size(), 2);
  EXPECT_FALSE(plan.edges()[2].is_left);
  before.put_back(plan);
  EXPECT_EQ(plan.nodes().size(), nodes);
  EXPECT_EQ(plan.edges().size(), edges);
  EXPECT_EQ(plan.other_end(0, 1), 0);
  EXPECT_EQ(plan.edges()[0].setbacks, setbacks);
  EXPECT_TRUE(plan.edges()[2].is_left);
  EXPECT_EQ(plan.nodes()[0].edges.size(), 3);
  EXPECT_TRUE(plan.nodes()[0].is_planned);
}

}  // namespace
}  // namespace dupin::network
