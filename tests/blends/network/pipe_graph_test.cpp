#include "dupin/blends/pipe_graph.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

PipeGraph graph_of(const std::vector<Vec3>& places, std::vector<GraphEdge> edges) {
  PipeGraph graph{"a.graph", {}, std::move(edges)};
  for (const Vec3& place : places) {
    const std::size_t i = graph.nodes.size();
    graph.nodes.push_back({std::to_string(i), place, {}, i + 1});
  }
  return graph;
}

std::ptrdiff_t euler_number(const PipeNetwork& network) {
  return 2 * (std::ptrdiff_t(network.components) - std::ptrdiff_t(network.cycles));
}

void expect_solid(const PipeNetwork& network, const std::string& what) {
  const Built built = build(network.assembly);
  EXPECT_EQ(built.solid.components(), network.components) << what;
  EXPECT_EQ(std::ptrdiff_t(built.solid.euler_number()), euler_number(network)) << what;
}

TEST(PipeGraph, bends_and_branches_are_smooth_where_they_fit) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {40, 40, 10}, {20, 40, 0}},
                                   {{0, 1}, {1, 2}, {2, 3}, {2, 4}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.blends, 1);
  EXPECT_EQ(network.junctions, 1);
  EXPECT_EQ(network.balls, 0);
  EXPECT_TRUE(network.notes.empty());
  EXPECT_EQ(network.assembly.tolerance, 0.04);
  expect_solid(network, "branch");
}

TEST(PipeGraph, cones_lead_between_different_radii) {
  PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {40, 5, 0}, {30, 20, 0}, {60, 0, 3}},
                             {{0, 1}, {1, 2}, {1, 3}, {2, 4}});
  const double radii[] = {3, 2, 1.5, 1, 0.5};
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    graph.nodes[i].radius = radii[i];
  }
  const PipeNetwork network = assembly_of(graph);
  EXPECT_EQ(network.balls, 0);
  expect_solid(network, "cones");
}

TEST(PipeGraph, cycles_are_handles) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}},
                                   {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.cycles, 2);
  EXPECT_EQ(network.junctions, 2);
  expect_solid(network, "square with a diagonal");
}

TEST(PipeGraph, balls_stand_where_nothing_smooth_fits) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {1, 0.4, 0}}, {{0, 1}, {1, 2}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.balls, 1);
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_EQ(network.notes.front().line, 2);
  EXPECT_THAT(network.notes.front().text, HasSubstr("node 1: a ball of radius 1.1, as "));
  expect_solid(network, "hairpin");
}

TEST(PipeGraph, crowded_junctions_become_something_smooth) {
  const PipeGraph graph =
      graph_of({{0, 0, 0}, {4, 0, 0}, {2.6, 3.1, 0}, {-20, 0, 0}, {30, -10, 3}, {5, 30, 0}},
               {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {2, 5}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.balls, 0);
  EXPECT_FALSE(network.notes.empty());
  expect_solid(network, "crowded");
}

TEST(PipeGraph, edges_that_pass_through_each_other_are_united) {
  const PipeGraph graph = graph_of({{-20, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, -20, 0}},
                                   {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.balls, 0);
  EXPECT_EQ(network.cycles, 0);
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_EQ(network.notes[0].text,
            "edge 3-4: passes through edge 0-1, to which it is not joined; united");
  const Built built = build(network.assembly);
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(built.solid.euler_number(), 0);
}

// Two long pipes through each other, with a junction in each: what joins them is cut apart.
TEST(PipeGraph, junctions_beside_edges_that_pass_are_united_too) {
  const PipeGraph graph = graph_of({{-20, 0, 0},
                                    {0, 0, 0},
                                    {20, 0, 0},
                                    {0, 20, 0},
                                    {10, -20, 0},
                                    {10, 20, 0},
                                    {10, 40, 0},
                                    {30, 20, 0}},
                                   {{0, 1}, {1, 2}, {1, 3}, {4, 5}, {5, 6}, {5, 7}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.junctions, 2);
  EXPECT_EQ(network.components, 2);
  const Built built = build(network.assembly);
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(built.solid.euler_number(), 2);
}

// A part that a build refuses is replaced, and what it was said with.
TEST(PipeGraph, a_build_that_is_to_keep_going_replaces_what_is_refused) {
  const PipeGraph graph =
      graph_of({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {40, 40, 10}}, {{0, 1}, {1, 2}, {2, 3}});
  const PipeGraphOptions options{.radius = 1, .keep_going = true};
  PipeNetwork network = assembly_of(graph, options);
  ASSERT_EQ(network.blends, 2);
  for (Part& part : network.assembly.parts) {
    if (part.name == "node 1") {
      part.shape = CyclicBlendBetween{
          {"edge 0-1", End::end}, {"edge 1-2", End::start}, {BlendLaw::r1, 0.01, 99}};
    }
  }
  EXPECT_THROW((void)build(network.assembly), Error);
  const Built built = build(graph, options, network);
  EXPECT_EQ(network.blends, 1);
  EXPECT_EQ(network.balls, 1);
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_TRUE(network.notes[0].is_refusal);
  EXPECT_THAT(network.notes[0].text, HasSubstr("node 1: a ball of radius 1.1, as "));
  EXPECT_EQ(built.solid.euler_number(), 2);
  PipeNetwork once = assembly_of(graph, {.radius = 1});
  once.assembly.parts[0].shape = PipeBetween{{0, 0, 0}, {0, 0, 0}, 1};
  EXPECT_THROW((void)build(graph, {.radius = 1}, once), Error);
}

TEST(PipeGraph, what_a_build_refuses_has_the_line_of_its_node_or_edge) {
  PipeGraph graph =
      graph_of({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {40, 40, 10}}, {{0, 1}, {1, 2}, {2, 3}});
  graph.source = "a.graph";
  for (std::size_t i = 0; i < 4; ++i) {
    graph.nodes[i].line = 10 + i;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    graph.edges[i].line = 20 + i;
  }
  const PipeGraphOptions options{.radius = 1};
  for (const auto& [name, place] :
       {std::pair("node 1", "a.graph:11"), {"edge 1-2", "a.graph:21"}}) {
    PipeNetwork network = assembly_of(graph, options);
    Part& part = *std::ranges::find(network.assembly.parts, name, &Part::name);
    if (part.name == "edge 1-2") {
      part.wall = 2;
    } else {
      part.shape = CyclicBlendBetween{
          {"edge 0-1", End::end}, {"edge 1-2", End::start}, {BlendLaw::r1, 0.01, 99}};
    }
    try {
      (void)build(graph, options, network);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.part(), name);
      EXPECT_EQ(error.where(), place);
      EXPECT_THAT(error.message(), HasSubstr("; --keep-going does without it"));
    }
  }
}

// The ball lies within the bore of a cone that leads to it.
TEST(PipeGraph, a_build_with_walls_that_is_to_keep_going_leaves_out_balls_that_are_refused) {
  PipeGraph graph =
      graph_of({{0, 0, 0}, {6, 0, 0}, {-30, 0, 0}, {-60, 5, 0}}, {{0, 1}, {0, 2}, {2, 3}});
  graph.nodes[1].radius = 5;
  const PipeGraphOptions options{
      .radius = 1, .keep_going = true, .refused = {{"node 0", "it is bad"}}};
  PipeNetwork network = assembly_of(graph, options);
  ASSERT_EQ(network.balls, 1);
  network.assembly.wall = .05;
  network.assembly.wall_side = WallSide::centred;
  EXPECT_THROW((void)build(network.assembly), Error);
  const Built built = build(graph, options, network);
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(network.edges, 1);
  EXPECT_EQ(network.nodes, 2);
  EXPECT_EQ(network.assembly.wall, .05);
  EXPECT_EQ(network.assembly.wall_side, WallSide::centred);
  const auto note = std::ranges::find_if(
      network.notes, [](const SourceNote& one) { return one.text.ends_with("with its edges"); });
  ASSERT_NE(note, network.notes.end());
  EXPECT_TRUE(note->is_refusal);
  EXPECT_THAT(note->text, HasSubstr("node 0: its surface lies inside of"));
}

TEST(PipeGraph, refused_edges_are_left_out) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}}, {{0, 1}, {1, 2}});
  const PipeNetwork network =
      assembly_of(graph, {.radius = 1, .refused = {{"edge 1-2", "it is bad"}}});
  EXPECT_EQ(network.edges, 1);
  EXPECT_EQ(network.nodes, 2);
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_EQ(network.notes[0].text, "edge 1-2: it is bad; left out");
  EXPECT_TRUE(network.notes[0].is_refusal);
}

TEST(PipeGraph, has_the_unit_it_is_told) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}}, {{0, 1}});
  EXPECT_EQ(assembly_of(graph, {.radius = 1, .unit = Unit::inch}).assembly.unit, Unit::inch);
}

TEST(PipeGraph, says_what_is_not_joined) {
  const PipeGraph graph =
      graph_of({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 0}}, {{0, 1}, {2, 3}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.components, 2);
  EXPECT_EQ(network.notes.front().text, "the graph has 2 parts that are not joined");
  expect_solid(network, "two pipes");
}

TEST(PipeGraph, radii_must_be_positive) {
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}}, {{0, 1}});
  EXPECT_THROW((void)assembly_of(graph), Error);
  EXPECT_THROW((void)assembly_of(graph, {.radius = 0}), Error);
  EXPECT_THROW((void)assembly_of(graph, {.radius = std::nan("")}), Error);
  for (const double tolerance : {0.0, -1.0, std::nan(""), double(INFINITY)}) {
    EXPECT_THROW((void)assembly_of(graph, {.radius = 1, .tolerance = tolerance}), Error);
  }
}

// Nodes on a jittered lattice, edges between neighbours there: none passes through another.
TEST(PipeGraph, random_graphs_become_solids_with_as_many_handles_as_cycles) {
  std::mt19937 random(18);
  const auto uniform = [&] { return double(random()) / 4294967296.0; };
  constexpr std::size_t kSide = 3;
  std::size_t smooth = 0;
  for (int trial = 0; trial < 24; ++trial) {
    std::vector<Vec3> places;
    std::vector<GraphEdge> edges;
    for (std::size_t i = 0; i < kSide * kSide * kSide; ++i) {
      const std::size_t x = i % kSide, y = i / kSide % kSide, z = i / kSide / kSide;
      places.push_back(20 * Vec3(double(x), double(y), double(z)) +
                       6 * Vec3(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5));
      const std::pair<std::size_t, std::size_t> axes[] = {{x, 1}, {y, kSide}, {z, kSide * kSide}};
      for (const auto& [at, step] : axes) {
        if (at > 0 && uniform() < 0.6) {
          edges.push_back({i - step, i});
        }
      }
    }
    PipeGraph graph = graph_of(places, std::move(edges));
    for (GraphNode& node : graph.nodes) {
      node.radius = trial % 2 == 0 ? 1 : 0.6 + uniform();
    }
    const PipeNetwork network = assembly_of(graph);
    smooth += network.junctions + network.blends;
    expect_solid(network, "trial " + std::to_string(trial));
  }
  EXPECT_GT(smooth, 400);
}

}  // namespace
}  // namespace dupin::test
