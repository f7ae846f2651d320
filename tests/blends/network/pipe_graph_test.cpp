#include "dupin/blends/pipe_graph.h"

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
  const PipeGraph graph = graph_of({{0, 0, 0}, {20, 0, 0}, {1, 1.5, 0}}, {{0, 1}, {1, 2}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.balls, 1);
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_EQ(network.notes.front().line, 2);
  EXPECT_THAT(network.notes.front().text, HasSubstr("node 1: a ball of radius 1.1, as "));
  expect_solid(network, "hairpin");
}

TEST(PipeGraph, crowded_junctions_are_narrower) {
  const PipeGraph graph =
      graph_of({{0, 0, 0}, {4, 0, 0}, {2.6, 3.1, 0}, {-20, 0, 0}, {30, -10, 3}, {5, 30, 0}},
               {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {2, 5}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.junctions, 1);
  ASSERT_FALSE(network.notes.empty());
  EXPECT_THAT(network.notes.front().text, HasSubstr("node 0: its radius of 1 made 0.85"));
  expect_solid(network, "crowded");
}

TEST(PipeGraph, edges_that_pass_through_each_other_are_united) {
  const PipeGraph graph = graph_of({{-20, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, -20, 0}},
                                   {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  const PipeNetwork network = assembly_of(graph, {.radius = 1});
  EXPECT_EQ(network.balls, 2);
  EXPECT_EQ(network.cycles, 0);
  const Built built = build(network.assembly);
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(built.solid.euler_number(), 0);
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
