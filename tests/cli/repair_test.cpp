#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using MeshCommands = Tool;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TriMesh cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

TEST_F(MeshCommands, repair_makes_a_solid_of_one_file) {
  put("two.off", joined({cube(0, 2), reversed(cube(1, 3))}));
  const auto report = json({"repair", "two.off", "-o", "out.off"}, 0);
  ASSERT_EQ(report.at("repairs").size(), 1);
  EXPECT_EQ(report.at("repairs")[0].at("file"), "two.off");
  EXPECT_EQ(report.at("repairs")[0].at("turned_faces"), 12);
  EXPECT_EQ(report.at("repairs")[0].at("united_overlaps"), true);
  EXPECT_EQ(report.at("check").at("volume"), 15);
  EXPECT_EQ(json({"check", "out.off"}, 0).at("solid"), true);
  EXPECT_THAT(dupin({"repair", "two.off", "-o", "out.off"}).out,
              HasSubstr("repaired             two.off: 12 faces turned, overlaps united\n"));
}

TEST_F(MeshCommands, repair_says_that_there_was_nothing_to_do) {
  put("a.off", cube(0, 2));
  EXPECT_THAT(dupin({"repair", "a.off", "-o", "b.stl"}).out,
              HasSubstr("repaired             a.off: nothing to mend\n"));
  EXPECT_EQ(json({"repair", "a.off", "-o", "b.stl"}, 0).at("repairs")[0].at("merged_points"), 0);
}

// One point of each pair along the edge is all that the file has: that is no solid yet.
TEST_F(MeshCommands, repair_says_that_points_were_doubled) {
  TriMesh edge = joined({cube(0, 2), test::box({2, 2, 0}, {3, 3, 2})});
  for (Triangle& t : edge.triangles) {
    for (std::uint32_t& corner : t) {
      for (std::uint32_t i = 0; i < corner; ++i) {
        corner = edge.points[i] == edge.points[corner] ? i : corner;
      }
    }
  }
  put("edge.off", edge);
  EXPECT_EQ(dupin({"check", "edge.off"}).exit_code, 1);
  const auto report = json({"repair", "edge.off", "-o", "out.off"}, 0);
  EXPECT_EQ(report.at("repairs")[0].at("united_overlaps"), false);
  EXPECT_EQ(report.at("repairs")[0].at("parted_contacts"), true);
  EXPECT_THAT(dupin({"repair", "edge.off", "-o", "out.off"}).out,
              HasSubstr("repaired             edge.off: points doubled where it touches itself\n"));
}

// A box of which a face is open, and each other one is there both ways round.
TEST_F(MeshCommands, repair_refuses_what_encloses_nothing) {
  TriMesh sheet = cube(0, 2);
  sheet.triangles.pop_back();
  sheet = joined({sheet, reversed(sheet)});
  put("sheet.off", sheet);
  put("a.off", cube(5, 6));
  for (const std::vector<std::string>& command : {std::vector<std::string>{"repair", "sheet.off"},
                                                  {"union", "a.off", "sheet.off", "--repair"}}) {
    std::vector<std::string> all = command;
    all.insert(all.end(), {"-o", "out.off"});
    const ProcessResult result = dupin(all);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("'sheet.off': it encloses nothing: of its 22 faces, 0 have"));
  }
  EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a.off", "sheet.off"}));
}

TEST_F(MeshCommands, repair_refuses_holes_and_writes_nothing) {
  TriMesh open = cube(0, 2);
  open.triangles.pop_back();
  put("open.off", open);
  const ProcessResult result = dupin({"repair", "open.off", "-o", "b.off"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err,
              StartsWith("dupin: 'open.off': the mesh cannot be repaired: 3 edges are open, first "
                         "the one from "));
  EXPECT_EQ(dupin({"check", "b.off"}).exit_code, 3) << "there should be no such file";
}

TEST_F(MeshCommands, repair_takes_no_tolerance_of_surfaces) {
  put("a.off", cube(0, 2));
  EXPECT_EQ(dupin({"repair", "a.off", "-o", "b.off", "--tolerance", "1"}).exit_code, 2);
}

}  // namespace
}  // namespace dupin::test
