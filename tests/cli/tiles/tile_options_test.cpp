#include "tiles/tile_options.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Eigen::AlignedBox3d cube(double x) { return {Vec3(x, 0, 0), Vec3(x + 1, 1, 1)}; }

TEST(TileOptions, tiles_are_as_many_as_asked_for_and_as_there_are) {
  const std::vector<Boxes> boxes(5, Boxes{cube(0)});
  const auto ends = [&](std::size_t tiles) {
    return ends_of_tiles({.tiles = tiles},
                         {.districts = boxes, .triangles = {}, .bytes = {}, .source = ""});
  };
  EXPECT_THAT(ends(1), ElementsAre(5));
  EXPECT_THAT(ends(2), ElementsAre(2, 5));
  EXPECT_THAT(ends(5), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(ends(64), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(ends(0), ElementsAre(5)) << "as with --cache alone";
}

TEST(TileOptions, memory_holds_every_tile) {
  const std::vector<Boxes> boxes{{cube(0)}, {cube(2)}, {cube(4)}, {cube(6)}};
  const std::vector<double> triangles{1000, 1000, 2500, 500};
  const std::vector<double> bytes{4e5, 4e5, 9.912e5, 2e5};
  const Divided divided{
      .districts = boxes, .triangles = triangles, .bytes = bytes, .source = "plant"};
  EXPECT_THAT(ends_of_tiles({.memory = "1MB"}, divided), ElementsAre(2, 3, 4));
  EXPECT_THAT(ends_of_tiles({.memory = "1GB"}, divided), ElementsAre(4));
  try {
    (void)ends_of_tiles({.memory = "900kB"}, divided);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_THAT(error.what(), HasSubstr("(4.5, 0.5, 0.5) has about 2.5e+03 triangles"));
    // What it asks for does.
    EXPECT_THAT(error.what(), HasSubstr("which need at least 1 MB;"));
    EXPECT_NO_THROW((void)ends_of_tiles({.memory = "1MB"}, divided));
    EXPECT_EQ(error.where(), "plant");
  }
}

TEST(TileOptions, pieces_are_made_until_all_fit_and_at_last_nothing_is_divided) {
  for (const std::size_t failures : {0U, 2U, 6U}) {
    std::vector<double> asked;
    const int made = until_pieces_fit(9000, [&](double most_of_piece) {
      asked.push_back(most_of_piece);
      return asked.size() > failures ? std::optional(17) : std::nullopt;
    });
    EXPECT_EQ(made, 17);
    ASSERT_EQ(asked.size(), failures + 1);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      EXPECT_EQ(asked[i], i < std::size_t(kMostRounds) ? 9000 : 0) << i;
    }
  }
}

TEST(TileOptions, files_grow_in_one_format_only) {
  EXPECT_EQ(why_not_tiled({"a.stl", kStlBinary}), "");
  EXPECT_THAT(why_not_tiled({"a.off", kOff}), HasSubstr("binary STL"));
  EXPECT_THAT(why_not_tiled({.path = "a.stl", .format = kStlBinary, .patches = "p"}),
              HasSubstr("--patches"));
  EXPECT_NO_THROW(require_tiled_output({"a.stl", kStlBinary}, {.tiles = 2}));
  EXPECT_THROW(require_tiled_output({"a.off", kOff}, {.tiles = 2}), UsageError);
  EXPECT_THROW(require_tiled_output({"-", kStlBinary}, {.tiles = 2}), UsageError);
  EXPECT_THROW(require_tiled_output({"a.stl", kStlBinary, Verification::full}, {.tiles = 2}),
               UsageError);
  EXPECT_THROW(require_tiled_output({"a.stl", kStlBinary}, {.memory = "4 gallons"}), UsageError);
}

}  // namespace
}  // namespace dupin::cli
