#include "tiles/tile_memory.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "ranks.h"

namespace dupin::cli {
namespace {

using testing::ElementsAre;

const Boxes kBoxes{{Vec3(0, 0, 0), Vec3(2, 4, 6)}};

std::vector<std::uint64_t> limits(TileMemory& memory, std::size_t districts) {
  std::vector<std::uint64_t> result;
  for (std::size_t i = 0; i < districts; ++i) {
    EXPECT_TRUE(memory.within(i, kBoxes, [&](std::uint64_t limit) {
      result.push_back(limit);
      return DistrictResult();
    }));
  }
  return result;
}

DistrictResult refused(std::uint64_t) { throw Error(Errc::limit_exceeded, "that is too much"); }

TEST(TileMemory, is_as_much_as_there_is) {
  TileMemory memory;
  memory.divide(std::vector<std::size_t>{1, 2});
  EXPECT_THAT(limits(memory, 2), ElementsAre(0, 0));
  EXPECT_TRUE(memory.bytes().empty());
  EXPECT_FALSE(memory.is_short(Ranks(), std::vector<std::size_t>(2, 0)));
}

TEST(TileMemory, each_district_has_what_the_others_of_its_tile_leave) {
  TileMemory memory(1000, {300, 600, 200, 0}, "plant");
  memory.divide(std::vector<std::size_t>{2, 4});
  EXPECT_THAT(limits(memory, 4), ElementsAre(400, 700, 1000, 800));
}

TEST(TileMemory, what_needs_more_has_to_be_alone) {
  TileMemory memory(1000, {300, 600, 200}, "plant", ", or less of it");
  memory.divide(std::vector<std::size_t>{2, 3});
  const std::vector<std::size_t> owners(3, 0);
  EXPECT_FALSE(memory.within(1, kBoxes, refused));
  EXPECT_TRUE(memory.is_short(Ranks(), owners));
  EXPECT_THAT(std::vector(memory.bytes().begin(), memory.bytes().end()),
              ElementsAre(300, 1000, 200));
  memory.divide(std::vector<std::size_t>{1, 2, 3});
  EXPECT_THAT(limits(memory, 3), ElementsAre(1000, 1000, 1000));
  EXPECT_FALSE(memory.is_short(Ranks(), owners)) << "said once";
  try {
    (void)memory.within(1, kBoxes, refused);
    FAIL() << "nothing leaves more to it";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_EQ(error.where(), "plant");
    EXPECT_EQ(error.message(),
              "what hangs together at (1, 2, 3): that is too much; give --memory more, or less of "
              "it");
  }
}

TEST(TileMemory, other_limits_are_no_matter_of_memory) {
  TileMemory memory(1000, {300, 600}, "plant");
  memory.divide(std::vector<std::size_t>{2});
  for (const Error& error : {Error(Errc::limit_exceeded, "too many triangles", "pipe"),
                             Error(Errc::infeasible_blend, "no blend")}) {
    EXPECT_THROW(
        (void)memory.within(0, kBoxes, [&](std::uint64_t) -> DistrictResult { throw error; }),
        Error);
  }
  EXPECT_FALSE(memory.is_short(Ranks(), std::vector<std::size_t>(2, 0)));
}

}  // namespace
}  // namespace dupin::cli
