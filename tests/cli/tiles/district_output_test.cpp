#include "tiles/district_output.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "exit_code.h"
#include "support/process.h"
#include "support/shapes.h"

namespace dupin::cli {
namespace {

const Destination kStl{"out.stl", kStlBinary};

TEST(DistrictOutput, boxes_reach_as_far_as_rounding_may_move) {
  const DistrictMargin floats = district_margin(kStl, {}, {});
  EXPECT_EQ(floats.absolute, 0);
  EXPECT_EQ(floats.relative, 1025 * 0x1p-23);
  EXPECT_EQ(district_margin({"out.off", kOff}, {}, {}).relative, 1025 * 0x1p-52);
  RoundingOptions given;
  given.tolerance = 3;
  EXPECT_EQ(district_margin(kStl, given, {}).absolute, 3);
  EXPECT_EQ(district_margin(kStl, given, {}).relative, 0x1p-23);
  // Numbers are as large as they are seen from the origin.
  RoundingOptions far;
  far.origin = {.choice = Origin::Choice::given, .place = Vec3(0, -1e9, 0)};
  EXPECT_EQ(district_margin(kStl, far, {}).absolute, 1025 * 0x1p-23 * 1e9);
}

TEST(DistrictOutput, all_districts_are_rounded_as_the_whole) {
  const std::vector<Boxes> boxes{{{Vec3(1, 2, 3), Vec3(4, 5, 6)}},
                                 {{Vec3(100, 2, 3), Vec3(104, 5, 6)}}};
  RoundingOptions automatic;
  automatic.origin.choice = Origin::Choice::automatic;
  const RoundingOptions whole = rounding_of_districts(automatic, boxes);
  EXPECT_EQ(whole.origin.choice, Origin::Choice::given);
  ASSERT_TRUE(whole.whole);
  // A change that does not double the extent changes nothing.
  std::vector<Boxes> grown = boxes;
  grown[1][0].max().y() = 7;
  EXPECT_EQ(rounding_of_districts({}, grown).whole->max(),
            rounding_of_districts({}, boxes).whole->max());
}

TEST(DistrictOutput, file_that_cannot_be_written_is_an_output_error) {
  const test::TemporaryFolder folder;
  const auto fails = [&](const std::string& path) {
    EXPECT_THROW(DistrictFile({path, kStlBinary}), OutputError) << path;
  };
  fails(folder.path().string());
  fails((folder.path() / "none" / "out.stl").string());
}

TEST(DistrictOutput, file_says_what_all_its_districts_are) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "out.stl").string();
  const std::vector<Solid> solids{Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                  Solid::from(test::box({5, 0, 0}, {6, 1, 1}))};
  const std::vector<Boxes> boxes{{{Vec3(-1, -1, -1), Vec3(2, 2, 2)}},
                                 {{Vec3(4, -1, -1), Vec3(7, 2, 2)}}};
  const Destination to{path, kStlBinary};
  DistrictFile file(to);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    file.append(district_output(solids[i], boxes, i, to, rounding_of_districts({}, boxes), {}));
  }
  const OutputReport report = file.commit({"mm", {}});
  EXPECT_EQ(report.file, path);
  EXPECT_EQ(report.check->triangles, 24U);
  EXPECT_EQ(report.check->components, 2U);
  EXPECT_EQ(Solid::from(read_mesh(path)).volume(), 2);
}

}  // namespace
}  // namespace dupin::cli
