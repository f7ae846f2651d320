#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

// Every command that reads a mesh, on coordinates out of range and at its ends.
namespace dupin::test {
namespace {

using CoordinateRange = Tool;
using ::testing::HasSubstr;

TriMesh block(double from, double to) { return box(Vec3::Constant(from), Vec3::Constant(to)); }

TEST_F(CoordinateRange, what_is_out_of_it_is_refused_by_all_that_need_a_solid) {
  put("good.off", block(0, 1));
  for (const double size : {5e-324, 1e-90, 1e150, 8e307}) {
    SCOPED_TRACE(size);
    put("bad.off", block(0, size));
    const std::vector<std::vector<std::string>> commands = {
        {"union", "good.off", "bad.off", "-o", "x.off"},
        {"intersect", "bad.off", "good.off", "-o", "x.stl"},
        {"boolean", "a", "a=bad.off", "-o", "x.off", "--repair"},
        {"repair", "bad.off", "-o", "x.off"},
        {"simplify", "bad.off", "x.off", "--tolerance", "1"},
        {"gaps", "bad.off", "good.off"}};
    for (const std::vector<std::string>& command : commands) {
      const ProcessResult result = dupin(command);
      EXPECT_EQ(result.exit_code, 3) << command[0] << ": " << result.err;
      EXPECT_THAT(result.err, HasSubstr(" coordinate ")) << command[0];
      EXPECT_THAT(result.err, HasSubstr("must be 0 or from 1e-60 to 1e+39 in size")) << command[0];
    }
  }
}

TEST_F(CoordinateRange, what_is_out_of_it_is_a_finding_and_can_be_looked_at_and_copied) {
  for (const double size : {5e-324, 1e-90, 1e150, 8e307}) {
    SCOPED_TRACE(size);
    put("bad.off", block(-size, size));
    const auto report = json({"check", "bad.off"}, 1);
    EXPECT_EQ(report.at("counts").at("point_out_of_range"), 8);
    EXPECT_EQ(report.at("solid"), false);
    EXPECT_EQ(json({"info", "bad.off"}, 0).at("check").at("volume"), 0);
    (void)json({"convert", "bad.off", "copy.ply"}, 0);
    EXPECT_EQ(json({"check", "copy.ply"}, 1).at("counts").at("point_out_of_range"), 8);
  }
}

TEST_F(CoordinateRange, at_its_ends_files_are_written_and_read) {
  for (const double size : {2e-60, 1e-45, 3e38, 1e39}) {
    SCOPED_TRACE(size);
    put("a.off", block(0, size));
    put("b.off", block(-size, size / 2));
    for (const std::string format : {"off", "obj", "ply"}) {
      const auto report = json({"union", "a.off", "b.off", "-o", "out." + format}, 0);
      EXPECT_EQ(report.at("check").at("solid"), true);
    }
  }
}

}  // namespace
}  // namespace dupin::test
