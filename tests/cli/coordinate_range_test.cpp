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
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

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
    for (const char* measure : {"volume", "area"}) {
      EXPECT_TRUE(report.at(measure).is_null()) << measure;
      EXPECT_TRUE(json({"info", "bad.off"}, 0).at("check").at(measure).is_null()) << measure;
    }
    for (const char* command : {"check", "info"}) {
      EXPECT_THAT(dupin({command, "bad.off"}).out,
                  ContainsRegex("volume +not known: points are out of range\narea +not known"));
    }
    (void)json({"convert", "bad.off", "copy.ply"}, 0);
    EXPECT_EQ(json({"check", "copy.ply"}, 1).at("counts").at("point_out_of_range"), 8);
  }
}

// A mesh that is no solid is refused as a solid is; one that is out of range may be put into it.
TEST_F(CoordinateRange, nothing_is_put_out_of_it) {
  TriMesh open = block(0, 1);
  open.triangles.pop_back();
  put("solid.off", block(0, 1));
  put("open.off", open);
  put("huge.off", block(0, 1e45));
  for (const char* factor : {"1e40", "1e-61", "1e300"}) {
    for (const char* file : {"solid.off", "open.off"}) {
      const ProcessResult result = dupin({"convert", file, "x.off", "--scale", factor});
      EXPECT_EQ(result.exit_code, 3) << file << " by " << factor;
      EXPECT_THAT(result.err, HasSubstr("out of range")) << file << " by " << factor;
    }
  }
  EXPECT_THAT(folder_.files(), Not(Contains("x.off")));
  const auto report = json({"convert", "huge.off", "x.off", "--scale", "1e-40"}, 0);
  EXPECT_EQ(report.at("check").at("solid"), true);
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
