#include "tiles/shared_tile.h"

#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
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
    std::size_t taken = 0;
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
        .parts = [](std::size_t i) { return std::vector{static_cast<std::uint32_t>(7 + i)}; },
        .taken =
            [&](std::size_t i, const DistrictResult& result) {
              EXPECT_EQ(i, taken++);
              const bool is_own = owners[i] == processes.own();
              EXPECT_EQ(result.built.parts.at(0).index, 7 + i);
              EXPECT_EQ(result.built.parts.at(0).name, "part " + std::to_string(i));
              EXPECT_EQ(result.output.piece.triangles, i);
              EXPECT_EQ(result.output.piece.is_elsewhere, !is_own);
              EXPECT_EQ(result.output.piece.bytes.size(), is_own ? 50 * i : 0);
            }};
    share_tile(owners, processes, work);
    EXPECT_EQ(taken, owners.size());
  });
}

TEST(SharedTile, has_the_fault_of_its_first_faulty_district) {
  const std::vector<std::size_t> owners{0, 2, 0, 1, 2};
  test::ThreadProcesses::run(3, [&](const Processes& processes) {
    const TileWork work{
        .made = [](std::size_t i) -> DistrictResult {
          if (i != 0) {
            throw Error(Errc::unroundable, "district " + std::to_string(i));
          }
          return {};
        },
        .parts = [](std::size_t) { return std::vector<std::uint32_t>(); },
        .taken = [](std::size_t i, const DistrictResult&) { ADD_FAILURE() << "district " << i; }};
    try {
      share_tile(owners, processes, work);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.message(),
                processes.own() == 2 ? "district 1" : "another process has found a fault");
    }
  });
}

TEST(SharedTile, is_taken_in_order_by_one_process) {
  std::vector<std::size_t> made(50), taken;
  const TileWork work{.made =
                          [&](std::size_t i) {
                            made[i] = 7 * i;
                            DistrictResult result;
                            result.output.piece.bytes = std::string(i, 'x');
                            return result;
                          },
                      .parts = [](std::size_t) { return std::vector<std::uint32_t>(); },
                      .taken =
                          [&](std::size_t i, const DistrictResult& result) {
                            EXPECT_EQ(result.output.piece.bytes.size(), i);
                            taken.push_back(7 * i);
                          }};
  test::ThreadProcesses::run(1, [&](const Processes& alone) {
    share_tile(std::vector<std::size_t>(made.size(), 0), alone, work);
  });
  EXPECT_EQ(taken, made);
}

}  // namespace
}  // namespace dupin::cli
