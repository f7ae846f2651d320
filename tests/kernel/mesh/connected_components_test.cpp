#include "dupin/kernel/connected_components.h"

#include <random>

#include <gtest/gtest.h>

namespace dupin {
namespace {

// Spreads the lowest point over all triangles until nothing changes.
std::vector<std::uint32_t> spread(const std::vector<Triangle>& triangles, std::uint32_t points) {
  std::vector<std::uint32_t> lowest(points);
  for (std::uint32_t i = 0; i < points; ++i) {
    lowest[i] = i;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t least = std::min({lowest[a], lowest[b], lowest[c]});
      for (const std::uint32_t p : {a, b, c}) {
        changed = changed || lowest[p] != least;
        lowest[p] = least;
      }
    }
  }
  return lowest;
}

TEST(ConnectedComponents, are_the_points_that_triangles_connect) {
  std::mt19937 random(4);
  for (const std::uint32_t points : {1U, 10U, 300U}) {
    for (int round = 0; round < 40; ++round) {
      std::vector<Triangle> triangles(random() % (points / 2 + 1));
      for (Triangle& t : triangles) {
        t = {static_cast<std::uint32_t>(random() % points),
             static_cast<std::uint32_t>(random() % points),
             static_cast<std::uint32_t>(random() % points)};
      }
      EXPECT_EQ(connected_components(triangles, points), spread(triangles, points));
    }
  }
}

TEST(ConnectedComponents, of_nothing_are_none) { EXPECT_TRUE(connected_components({}, 0).empty()); }

}  // namespace
}  // namespace dupin
