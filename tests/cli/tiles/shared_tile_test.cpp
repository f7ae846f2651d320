#include "tiles/shared_tile.h"

#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/thread_processes.h"

namespace dupin::cli {
namespace {

using testing::ElementsAre;

TEST(SharedTile, is_shared_out_by_triangles) {
  const std::vector<double> triangles{1, 8, 3, 3, 1};
  EXPECT_THAT(shared_out(triangles, 1), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_THAT(shared_out(triangles, 2), ElementsAre(1, 0, 1, 1, 1));
  // Tile by tile.
  const std::vector<std::size_t> ends{2, 5};
  EXPECT_THAT(shared_out(triangles, ends, 2), ElementsAre(1, 0, 0, 1, 0));
}

TEST(SharedTile, is_known_to_all_but_for_the_facets_of_others) {
  const std::vector<std::size_t> owners{0, 2, 0, 1};
  test::ThreadProcesses::run(3, [&](const Processes& processes) {
    const TileWork work{
        .made =
            [&](std::size_t i) {
              EXPECT_EQ(owners[i], processes.own());
              DistrictResult result;
              PartReport part;
              part.index = static_cast<std::uint32_t>(7 + i);
              part.name = "part " + std::to_string(i);
              result.built.parts.push_back(part);
              result.output.piece.bytes = std::string(50 * i, 'x');
              result.output.piece.triangles = static_cast<std::uint32_t>(i);
              return result;
            },
        .parts = [](std::size_t i) { return std::vector{static_cast<std::uint32_t>(7 + i)}; }};
    const auto tile = shared_tile(owners, processes, work);
    ASSERT_EQ(tile.size(), owners.size());
    for (std::size_t i = 0; i < tile.size(); ++i) {
      ASSERT_TRUE(tile[i]);
      const bool is_own = owners[i] == processes.own();
      EXPECT_EQ(tile[i]->built.parts.at(0).index, 7 + i);
      EXPECT_EQ(tile[i]->built.parts.at(0).name, "part " + std::to_string(i));
      EXPECT_EQ(tile[i]->output.piece.triangles, i);
      EXPECT_EQ(tile[i]->output.piece.is_elsewhere, !is_own);
      EXPECT_EQ(tile[i]->output.piece.bytes.size(), is_own ? 50 * i : 0);
    }
  });
}

}  // namespace
}  // namespace dupin::cli
