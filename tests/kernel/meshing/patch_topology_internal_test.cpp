#include <vector>

#include <gtest/gtest.h>

#include "meshing/patch_topology.h"

namespace dupin::meshing {
namespace {

// A square of two triangles: 0 1 2 3 around.
const std::vector<Triangle> kSquare = {{0, 1, 2}, {0, 3, 2}};
const std::vector<BorderChain> kRim = {{{0, 1, 2}, 1}, {{2, 3, 0}, 1}};

TEST(PatchTopology, turns_neighbours_to_agree_and_the_sum_outward) {
  for (const double sign : {1.0, -1.0}) {
    std::vector<Triangle> triangles = kSquare;
    // As given, they look away from each other.
    ASSERT_TRUE(turn_outward(triangles, std::vector{2 * sign, -sign}, kRim));
    const std::vector<Triangle> expected = sign > 0 ? std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}
                                                    : std::vector<Triangle>{{0, 2, 1}, {0, 3, 2}};
    EXPECT_EQ(triangles, expected);
  }
}

TEST(PatchTopology, misses_an_edge_of_a_chain) {
  std::vector<Triangle> triangles = kSquare;
  EXPECT_FALSE(turn_outward(triangles, std::vector{1.0, -1.0},
                            std::vector<BorderChain>{{{0, 1, 2}, 1}, {{2, 4, 3, 0}, 1}}));
}

TEST(PatchTopology, sees_a_border_that_is_none_of_the_chains) {
  std::vector<Triangle> triangles = kSquare;
  EXPECT_FALSE(
      turn_outward(triangles, std::vector{1.0, -1.0}, std::vector<BorderChain>{{{0, 1, 2}, 1}}));
}

TEST(PatchTopology, counts_the_sides_of_a_chain) {
  std::vector<Triangle> triangles = kSquare;
  std::vector<BorderChain> chains = kRim;
  chains.push_back({{0, 2}, 2});
  EXPECT_TRUE(turn_outward(triangles, std::vector{1.0, -1.0}, chains));
  chains.back().sides = 1;
  EXPECT_FALSE(turn_outward(triangles, std::vector{1.0, -1.0}, chains));
}

TEST(PatchTopology, refuses_a_band_with_one_side) {
  // Moebius' band of five triangles.
  std::vector<Triangle> band = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  const std::vector<BorderChain> rim = {{{0, 2, 4, 1, 3, 0}, 1}};
  EXPECT_FALSE(turn_outward(band, std::vector<double>(5, 1), rim));
}

}  // namespace
}  // namespace dupin::meshing
