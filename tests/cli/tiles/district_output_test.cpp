#include "tiles/district_output.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
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
  EXPECT_EQ(rounding_of_districts({}, grown).whole->largest,
            rounding_of_districts({}, boxes).whole->largest);
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
  const DistrictPlaces places(boxes);
  DistrictFile file(to, places.by_district());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    file.append(
        district_output(solids[i], boxes, i, places, to, rounding_of_districts({}, boxes), {}));
  }
  const OutputReport report = file.commit({"mm", {}});
  EXPECT_EQ(report.file, path);
  EXPECT_EQ(report.check->triangles, 24U);
  EXPECT_EQ(report.check->components, 2U);
  EXPECT_EQ(Solid::from(read_mesh(path)).volume(), 2);
}

TEST(DistrictOutput, file_of_which_rounding_leaves_nothing_is_not_written) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "out.stl").string();
  const std::vector<Solid> specks{Solid::from(test::box({1e5, 0, 0}, {1e5 + 0x1p-12, 1e-5, 1e-5})),
                                  Solid::from(test::box({2e5, 0, 0}, {2e5 + 0x1p-12, 1e-5, 1e-5}))};
  const std::vector<Boxes> boxes{{{Vec3(1e5 - 9, -9, -9), Vec3(1e5 + 9, 9, 9)}},
                                 {{Vec3(2e5 - 9, -9, -9), Vec3(2e5 + 9, 9, 9)}}};
  const Destination to{path, kStlBinary};
  const RoundingOptions rounding = rounding_of_districts({}, boxes);
  const auto code = [](const auto& action) -> std::optional<Errc> {
    try {
      action();
      return std::nullopt;
    } catch (const Error& error) {
      return error.code();
    }
  };
  EXPECT_EQ(code([&] { (void)write_districts(specks, boxes, to, {}, {}, {}, nullptr, {}); }),
            Errc::unroundable);
  EXPECT_EQ(code([&] {
              DistrictFile file(to);
              for (std::size_t i = 0; i < specks.size(); ++i) {
                file.append(
                    district_output(specks[i], boxes, i, DistrictPlaces(boxes), to, rounding, {}));
              }
              file.require_something(rounding);
            }),
            Errc::unroundable);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace dupin::cli
