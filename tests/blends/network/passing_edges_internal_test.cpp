#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "network/passing_edges.h"

namespace dupin::network {
namespace {

using testing::ElementsAre;

TEST(PassingEdges, are_those_whose_capsules_meet_unless_they_share_a_node) {
  CleanGraph graph;
  for (const Vec3& at : {Vec3(-5, 0, 0), Vec3(5, 0, 0), Vec3(0, -5, 1.5), Vec3(0, 5, 1.5),
                         Vec3(0, -5, 9), Vec3(5, 9, 0)}) {
    graph.nodes.push_back({"", at, 1, 0});
  }
  graph.edges = {{0, 1}, {2, 3}, {2, 4}, {1, 5}};
  EXPECT_THAT(passing_edges(graph), ElementsAre(true, true, false, false));
  for (Ball& ball : graph.nodes) {
    ball.radius = 0.7;
  }
  EXPECT_THAT(passing_edges(graph), ElementsAre(false, false, false, false));
}

}  // namespace
}  // namespace dupin::network
