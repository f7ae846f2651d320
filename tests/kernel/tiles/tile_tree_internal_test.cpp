#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tiles/tile_tree.h"

namespace dupin::tiles {
namespace {

Place random_place(std::mt19937& random) {
  const auto some = [&] { return static_cast<float>(random() % 20); };
  return {some(), some(), some()};
}

TEST(TileTree, shares_out_places_evenly) {
  std::mt19937 random(1);
  std::vector<Place> sample;
  for (int i = 0; i < 9000; ++i) {
    sample.push_back({static_cast<float>(i), static_cast<float>(random() % 100), 0});
  }
  const TileTree tree(sample, 9);
  ASSERT_EQ(tree.size(), 9);
  std::vector<int> counts(9);
  for (const Place& place : sample) {
    ++counts[tree.tile_of(place)];
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 1000, 10);
  }
}

TEST(TileTree, has_no_more_tiles_than_places) {
  EXPECT_EQ(TileTree({}, 5).size(), 1);
  EXPECT_EQ(TileTree({{1, 1, 1}, {1, 1, 1}}, 5).size(), 1);
  EXPECT_EQ(TileTree({{1, 1, 1}, {1, 2, 1}, {1, 1, 1}, {1, 1, 1}}, 5).size(), 2);
}

// What tiles count by: the tile of a place in a box is one that the box reaches into.
TEST(TileTree, finds_all_tiles_of_a_box) {
  std::mt19937 random(2);
  std::vector<Place> sample;
  for (int i = 0; i < 200; ++i) {
    sample.push_back(random_place(random));
  }
  const TileTree tree(sample, 40);
  for (int i = 0; i < 2000; ++i) {
    const Place a = random_place(random), b = random_place(random);
    PlaceBox box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(a[k], b[k]);
      box.high[k] = std::max(a[k], b[k]);
    }
    std::set<std::uint32_t> tiles, expected;
    tree.for_each_tile(box, [&](std::uint32_t tile) { EXPECT_TRUE(tiles.insert(tile).second); });
    for (float x = box.low[0]; x <= box.high[0]; ++x) {
      for (float y = box.low[1]; y <= box.high[1]; ++y) {
        for (float z = box.low[2]; z <= box.high[2]; ++z) {
          expected.insert(tree.tile_of({x, y, z}));
        }
      }
    }
    EXPECT_EQ(tiles, expected);  // planes are at integers, too
  }
}

}  // namespace
}  // namespace dupin::tiles
