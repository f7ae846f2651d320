#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using MeshCommands = Tool;

TEST_F(MeshCommands, check_reports_a_solid) {
  put("a.off", frame());
  const ProcessResult result = dupin({"check", "a.off"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("volume               64\n"));
  EXPECT_THAT(result.out, HasSubstr("watertight           yes\n"));
  const auto report = json({"check", "a.off"}, 0);
  EXPECT_EQ(report.at("solid"), true);
  EXPECT_EQ(report.at("volume"), 64);
  EXPECT_EQ(report.at("genus"), 1);
  EXPECT_EQ(report.at("counts"), nlohmann::json::object());
}

TEST_F(MeshCommands, check_lists_faults_with_faces_and_places) {
  put("a.off", open_box());
  const ProcessResult result = dupin({"check", "a.off"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("watertight           no\n"));
  EXPECT_THAT(result.out, Not(HasSubstr("volume")));
  EXPECT_THAT(result.out, HasSubstr("boundary_edge: 3\n"));
  const auto report = json({"check", "a.off"}, 1);
  EXPECT_EQ(report.at("counts"), (nlohmann::json{{"boundary_edge", 3}}));
  EXPECT_TRUE(report.at("volume").is_null());
  EXPECT_TRUE(report.at("genus").is_null());
  EXPECT_EQ(report.at("findings").size(), 3);
  EXPECT_EQ(report.at("findings")[0].at("defect"), "boundary_edge");
  EXPECT_EQ(report.at("findings")[0].at("faces").size(), 1);
}

TEST_F(MeshCommands, check_reads_standard_input) {
  const std::string bytes = mesh_bytes(frame(), kStlBinary);
  EXPECT_EQ(dupin({"check", "-"}, bytes).exit_code, 0);
  EXPECT_EQ(dupin({"check", "-"}, "nonsense").exit_code, 3);
}

TEST_F(MeshCommands, malformed_files_are_named_with_the_place) {
  const std::vector<std::pair<std::string, std::string>> table{
      {"OFF\n1 0 0\n0 nan 0\n", "a.off:3: found 'nan', expected a coordinate that is finite"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
       "a.off:6: found '3', expected the index of a vertex, an integer from 0 to 2"},
      {"OFF\n4000000000 4000000000 0\n0 0 0\n",
       "a.off:2: found counts of 4000000000 vertices and 4000000000 faces, expected at least "
       "56000000000 bytes after them, not 6"},
      {"solid a\nfacet\n", "a.off:3: found the end of the file, expected 'normal'"},
  };
  for (const auto& [text, message] : table) {
    folder_.write("a.off", text);
    for (const std::string command : {"check", "info", "gaps"}) {
      const ProcessResult result = dupin({command, "a.off"});
      EXPECT_EQ(result.exit_code, 3);
      EXPECT_EQ(result.err, "dupin: " + message + "\n");
      EXPECT_EQ(result.out, "");
    }
    const ProcessResult quiet = dupin({"convert", "a.off", "b.off", "--quiet"});
    EXPECT_EQ(quiet.err, "dupin: " + message + "\n");
  }
  EXPECT_THAT(folder_.files(), ElementsAre("a.off"));
}

TEST_F(MeshCommands, files_that_show_no_triangle_are_refused) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  folder_.write("cloud.off", "OFF\n1 0 0\n0 0 0\n");
  folder_.write("cloud.obj", "v 0 0 0\n");
  for (const std::string name : {"cloud.off", "cloud.obj"}) {
    EXPECT_EQ(dupin({"check", name}).exit_code, 3) << name;
    EXPECT_EQ(dupin({"union", "a.off", name, "-o", "b.off"}).exit_code, 3) << name;
  }
}

TEST_F(MeshCommands, the_empty_set_goes_through_every_format) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({5, 0, 0}, {6, 1, 1}));
  for (const std::string format :
       {"off", "stl", "stl-ascii", "ply", "ply-ascii", "obj", "3mf", "glb"}) {
    const std::string name = "c." + format.substr(0, 3);
    EXPECT_EQ(dupin({"intersect", "a.off", "b.off", "-o", name, "--format", format}).exit_code, 0);
    EXPECT_EQ(json({"union", "a.off", name, "-o", "d.off"}, 0).at("check").at("volume"), 1)
        << format;
  }
}

}  // namespace
}  // namespace dupin::test
