#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "network/clean_graph.h"

namespace dupin::network {
namespace {

using testing::HasSubstr;

PipeGraph graph_of(std::vector<GraphNode> nodes, std::vector<GraphEdge> edges) {
  std::size_t line = 0;
  for (GraphNode& node : nodes) {
    node.line = ++line;
    node.name = std::to_string(line);
  }
  for (GraphEdge& edge : edges) {
    edge.line = ++line;
  }
  return {"a.graph", std::move(nodes), std::move(edges)};
}

GraphNode node(double x, std::optional<double> radius = 1) { return {{}, Vec3(x, 0, 0), radius}; }

// Of one note, or of the first.
std::string first_note(const CleanGraph& clean) {
  return clean.notes.empty() ? "" : clean.notes.front().text;
}

TEST(CleanGraph, leaves_what_is_clean) {
  const CleanGraph clean = cleaned(graph_of({node(0), node(9, 2)}, {{0, 1}}), {});
  EXPECT_TRUE(clean.notes.empty());
  EXPECT_EQ(clean.nodes.size(), 2);
  EXPECT_EQ(clean.nodes[1].radius, 2);
  EXPECT_EQ(clean.edges.size(), 1);
}

TEST(CleanGraph, merges_nodes_at_the_same_place) {
  const CleanGraph clean =
      cleaned(graph_of({node(0), node(9), node(9, 2), node(20)}, {{0, 1}, {2, 3}, {1, 2}}), {});
  EXPECT_EQ(clean.nodes.size(), 3);
  EXPECT_EQ(clean.nodes[1].radius, 2);
  EXPECT_EQ(clean.edges.size(), 2);
  ASSERT_EQ(clean.notes.size(), 2);
  EXPECT_EQ(clean.notes[0].text, "node 3: at the same place as node 2; merged with it");
  EXPECT_EQ(clean.notes[1].text, "edge 2-3: has no length; dropped");
  EXPECT_EQ(clean.notes[1].line, 7);
}

TEST(CleanGraph, drops_loops_double_edges_and_lonely_nodes) {
  const CleanGraph clean =
      cleaned(graph_of({node(0), node(9), node(50)}, {{0, 0}, {0, 1}, {1, 0}}), {});
  EXPECT_EQ(clean.edges.size(), 1);
  EXPECT_EQ(clean.nodes.size(), 2);
  ASSERT_EQ(clean.notes.size(), 3);
  EXPECT_EQ(clean.notes[0].text, "edge 1-1: leads from a node to itself; dropped");
  EXPECT_EQ(clean.notes[1].text, "edge 2-1: joins nodes that are joined already; dropped");
  EXPECT_EQ(clean.notes[2].text, "node 3: has no edge; dropped");
}

TEST(CleanGraph, gives_nodes_without_a_positive_radius_one) {
  const PipeGraph graph = graph_of({node(0, 3), node(9, 0), node(20, -1)}, {{0, 1}, {1, 2}});
  const CleanGraph clean = cleaned(graph, {});
  EXPECT_EQ(clean.nodes[2].radius, 3);
  EXPECT_EQ(first_note(clean), "node 2: its radius of 0 is not positive; given that of node 1, 3");
  const CleanGraph given = cleaned(graph, {.radius = 2});
  EXPECT_EQ(given.nodes[1].radius, 2);
  EXPECT_EQ(given.nodes[0].radius, 3);
  EXPECT_THAT(first_note(given), HasSubstr("given that of --radius, 2"));
}

TEST(CleanGraph, merges_balls_inside_of_their_neighbours) {
  const CleanGraph clean =
      cleaned(graph_of({node(0, 5), node(3, 1), node(20, 1)}, {{0, 1}, {1, 2}}), {});
  EXPECT_EQ(clean.nodes.size(), 2);
  EXPECT_EQ(clean.edges.size(), 1);
  EXPECT_EQ(first_note(clean), "node 2: its ball lies in that of node 1; merged with it");
}

TEST(CleanGraph, drops_what_is_nowhere_unless_it_is_used) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(first_note(cleaned(graph_of({node(0), node(9), node(nan)}, {{0, 1}}), {})),
              HasSubstr("node 3: its coordinates must be finite"));
}

TEST(CleanGraph, refuses_radii_that_leave_no_tolerance) {
  EXPECT_EQ(cleaned(graph_of({node(0, kLeastRadius), node(9)}, {{0, 1}}), {}).nodes.size(), 2);
  try {
    (void)cleaned(graph_of({node(0), node(9, 1e-13)}, {{0, 1}}), {});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "node 2: its radius must be at least 2.5e-11, not 1e-13");
    EXPECT_EQ(error.where(), "a.graph:2");
  }
}

TEST(CleanGraph, refuses_with_the_line_or_leaves_out) {
  struct Row {
    PipeGraph graph;
    std::string where, message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Row rows[] = {
      {graph_of({node(0), node(9), node(20, {})}, {{0, 1}, {1, 2}}), "a.graph:3",
       "node 3: has no radius"},
      {graph_of({node(0), node(9), node(nan)}, {{0, 1}, {1, 2}}), "a.graph:3",
       "node 3: its coordinates"},
      {graph_of({node(0), node(9), node(1e300)}, {{0, 1}, {1, 2}}), "a.graph:3",
       "node 3: its coordinates"},
      {graph_of({node(0), node(9), node(20, 0), node(30, 0)}, {{0, 1}, {2, 3}}), "a.graph:3",
       "node 3: its radius is not positive"},
      {graph_of({node(0), node(9)}, {{0, 1}, {1, 5}}), "a.graph:4", "does not exist"}};
  for (const Row& row : rows) {
    try {
      (void)cleaned(row.graph, {});
      ADD_FAILURE() << row.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.where(), row.where);
      EXPECT_THAT(error.message(), HasSubstr(row.message));
    }
    const CleanGraph clean = cleaned(row.graph, {.keep_going = true});
    EXPECT_EQ(clean.edges.size(), 1) << row.message;
    EXPECT_TRUE(clean.notes.front().is_refusal) << row.message;
  }
  EXPECT_THROW((void)cleaned(graph_of({node(0)}, {}), {}), Error);
}

}  // namespace
}  // namespace dupin::network
