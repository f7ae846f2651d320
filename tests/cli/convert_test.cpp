#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using MeshCommands = Tool;

TEST_F(MeshCommands, convert_keeps_a_mesh_in_every_format) {
  put("a.off", frame());
  const auto original = json({"check", "a.off"}, 0);
  for (const MeshFormat& row : mesh_formats()) {
    const std::string format(row.key);
    const auto report = json({"convert", "a.off", "b", "--format", format}, 0);
    EXPECT_EQ(report.at("check").at("volume"), original.at("volume")) << format;
    EXPECT_EQ(report.at("check").at("triangles"), original.at("triangles")) << format;
    EXPECT_EQ(json({"check", "b"}, 0), report.at("check")) << format;
  }
}

TEST_F(MeshCommands, convert_rounds_a_solid_so_that_it_stays_one) {
  put("a.off", moved(tube(1.0 / 3, 0, 1, 24), {0.1, 0.2, 0.3}));
  const auto report = json({"convert", "a.off", "b.stl"}, 0);
  EXPECT_EQ(report.at("rounding").at("coordinates"), "binary32");
  EXPECT_GT(report.at("rounding").at("moved_points"), 0);
  EXPECT_LT(report.at("rounding").at("largest_move"), 1e-6);
  EXPECT_EQ(report.at("check").at("solid"), true);
}

TEST_F(MeshCommands, convert_moves_the_origin_and_says_so) {
  put("a.off", moved(tube(10, 0, 50, 24), {238409, 81742, 606708}));
  const auto kept = json({"convert", "a.off", "kept.stl"}, 0);
  const auto moved_by = json({"convert", "a.off", "b.stl", "--origin", "auto"}, 0);
  EXPECT_EQ(kept.at("rounding").at("origin"), (std::vector<double>{0, 0, 0}));
  EXPECT_NEAR(moved_by.at("rounding").at("origin")[2], 606708 + 25, 25);
  EXPECT_GT(kept.at("rounding").at("largest_move"), 0x1p-8) << "floats are 2^-6 apart there";
  EXPECT_LT(moved_by.at("rounding").at("largest_move"), 1e-5);
  EXPECT_THAT(folder_.read("b.stl").substr(0, 80), HasSubstr("origin at "));
  const auto given = json({"convert", "a.off", "c.off", "--origin", "238409,81742,606708"}, 0);
  EXPECT_EQ(given.at("rounding").at("origin"), (std::vector<double>{238409, 81742, 606708}));
}

TEST_F(MeshCommands, convert_snaps_to_a_grid) {
  put("a.off", moved(box({0, 0, 0}, {1, 1, 1}), {0.1, 0.2, 0.3}));
  const auto report = json({"convert", "a.off", "b.off", "--grid", "0.25"}, 0);
  EXPECT_EQ(report.at("check").at("volume"), 1);
  EXPECT_EQ(report.at("rounding").at("moved_points"), 8);
}

TEST_F(MeshCommands, convert_writes_what_is_no_solid_as_it_is) {
  put("a.off", moved(open_box(), {0.1, 0.2, 0.3}));
  const auto report = json({"convert", "a.off", "b.stl"}, 0);
  EXPECT_EQ(report.at("check").at("solid"), false);
  EXPECT_EQ(report.at("check").at("triangles"), 11);
  EXPECT_EQ(report.at("rounding").at("moved_points"), 8);
}

// The square of such a move is 0.
TEST_F(MeshCommands, convert_says_that_it_moved_points_however_little) {
  put("a.off", moved(box({0, 0, 0}, {1e-310, 1e-310, 1e-310}), {0, 0, 0}));
  const auto report = json({"convert", "a.off", "b.stl"}, 0);
  EXPECT_EQ(report.at("rounding").at("moved_points"), 7);
  EXPECT_GE(report.at("rounding").at("largest_move").get<double>(), 1e-310);
}

TEST_F(MeshCommands, convert_parts_what_readers_of_stl_would_weld) {
  put("a.off", joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}));
  for (const char* const format : {"stl", "stl-ascii"}) {
    const auto report = json({"convert", "a.off", "b.stl", "--format", format}, 0);
    EXPECT_EQ(report.at("check").at("solid"), true) << format;
    EXPECT_EQ(json({"check", "b.stl"}, 0).at("components"), 2) << format;
  }
  const auto kept = json({"convert", "a.off", "b.ply"}, 0);
  EXPECT_EQ(kept.at("rounding").at("moved_points"), 0);
  EXPECT_EQ(json({"check", "b.ply"}, 0).at("volume"), 2);
}

TEST_F(MeshCommands, convert_takes_no_option_that_says_nothing_of_the_input) {
  put("solid.off", box({0, 0, 0}, {1, 1, 1}));
  put("open.off", open_box());
  const std::string graph = example("neuron.swc");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table = {
      {{"solid.off", "b.off", "--unit", "mm"}, "--unit"},
      {{"solid.off", "b.off", "--radius", "1"}, "--radius"},
      {{"solid.off", "b.off", "--snap", "1"}, "--snap"},
      {{"solid.off", "b.off", "--schedule", "40"}, "--schedule"},
      {{"solid.off", "b.off", "--fillet", "auto"}, "--fillet"},
      {{"solid.off", "b.off", "--strict"}, "--strict"},
      {{"solid.off", "b.off", "--wall", "1"}, "--wall"},
      {{"solid.off", "b.off", "--insulation", "1"}, "--insulation"},
      {{"open.off", "b.off", "--origin", "auto"}, "--origin"},
      {{"open.off", "b.off", "--grid", "0.25"}, "--grid"},
      {{"open.off", "b.off", "--rounding-tolerance", "1"}, "--rounding-tolerance"},
      {{"open.off", "b.off", "--scale", "2", "--grid", "0.25"}, "--grid"},
      {{graph, "b.json", "--origin", "auto"}, "--origin"},
      {{graph, "b.json", "--grid", "0.25"}, "--grid"},
      {{graph, "b.json", "--rounding-tolerance", "1"}, "--rounding-tolerance"},
      {{graph, "b.json", "--verify", "full"}, "--verify"},
      {{graph, "b.json", "--no-verify"}, "--no-verify"},
      {{graph, "b.json", "--patches", "p.json"}, "--patches"},
      {{graph, "b.json", "--to-unit", "in"}, "--to-unit"}};
  for (const auto& [arguments, option] : table) {
    std::vector<std::string> command = arguments;
    command.insert(command.begin(), "convert");
    const ProcessResult result = dupin(command);
    EXPECT_EQ(result.exit_code, 2) << option << " of " << arguments[0];
    EXPECT_THAT(result.err, HasSubstr(option));
  }
  for (const std::string command : {"info", "report", "gaps"}) {
    EXPECT_EQ(dupin({command, "solid.off", "--unit", "mm"}).exit_code, 2) << command;
  }
}

TEST_F(MeshCommands, convert_changes_the_unit) {
  put("a.off", box({0, 0, 0}, {254, 508, 2540}));
  const auto report = json({"convert", "a.off", "b.off", "--to-unit", "in"}, 0);
  EXPECT_EQ(report.at("check").at("volume"), 20000);
  EXPECT_EQ(json({"info", "b.off"}, 0).at("unit"), "in");
  EXPECT_EQ(json({"convert", "b.off", "c.3mf", "--to-unit", "um"}, 0).at("check").at("solid"),
            true);
  EXPECT_EQ(json({"info", "c.3mf"}, 0).at("unit"), "um");
  EXPECT_EQ(json({"info", "c.3mf"}, 0).at("box"),
            (nlohmann::json{{0, 0, 0}, {254000, 508000, 2540000}}));
  (void)json({"convert", "c.3mf", "d.off", "--translate", "1mm,2,0", "--to-unit", "mm"}, 0);
  EXPECT_EQ(json({"info", "d.off"}, 0).at("box")[0], (nlohmann::json{1, 0.002, 0}));
  (void)json({"convert", "b.off", "b2.off", "--to-unit", "in"}, 0);
  EXPECT_EQ(folder_.read("b2.off"), folder_.read("b.off"));
  folder_.write("e.off", "OFF\n# unit: mm\n" + folder_.read("a.off").substr(4));
  EXPECT_EQ(dupin({"union", "b.off", "e.off", "-o", "f.off"}).exit_code, 3);
  EXPECT_EQ(dupin({"convert", "e.off", "g.off", "--to-unit", "in"}).exit_code, 0);
  EXPECT_EQ(dupin({"union", "b.off", "g.off", "-o", "f.off"}).exit_code, 0);
}

TEST_F(MeshCommands, microns_are_a_unit_of_meshes) {
  put("a.off", box({0, 0, 0}, {1000, 2000, 3000}));
  folder_.write("a.off", "OFF\n# unit: um\n" + folder_.read("a.off").substr(4));
  (void)json({"convert", "a.off", "b.off", "--translate", "1mm,5um,7"}, 0);
  EXPECT_EQ(json({"info", "b.off"}, 0).at("box")[0], (nlohmann::json{1000, 5, 7}));
  EXPECT_EQ(dupin({"simplify", "a.off", "c.off", "--tolerance", "1um"}).exit_code, 0);
  EXPECT_EQ(dupin({"remesh", "a.off", "c.off", "--tolerance", "0.1mm"}).exit_code, 0);
  EXPECT_EQ(dupin({"convert", "a.off", "c.off", "--grid", "2"}).exit_code, 0);
}

// Said beside a graph, too, and not dropped.
TEST_F(MeshCommands, writes_the_wall_of_a_graph) {
  const ProcessResult result =
      dupin({"convert", example("neuron.swc"), "neuron.json", "--wall", "0.1"});
  EXPECT_LE(result.exit_code, 1) << result.err;
  EXPECT_EQ(nlohmann::json::parse(folder_.read("neuron.json")).at("wall"), 0.1);
}

// A solid that need not be rounded is proved for it, and written the same.
TEST_F(MeshCommands, convert_compares_what_is_read_back_where_that_is_asked_for) {
  put("a.off", box({0, 0, 0}, {2, 3, 4}));
  put("open.off", open_box());
  const auto how = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "convert");
    return json(arguments, 0).at("verification");
  };
  EXPECT_EQ(how({"a.off", "usual.stl"}), "full");
  EXPECT_EQ(how({"a.off", "full.stl", "--verify", "full"}), "full");
  EXPECT_EQ(how({"a.off", "compare.stl", "--verify", "compare"}), "compare");
  EXPECT_EQ(how({"open.off", "open.stl", "--verify", "compare"}), "full");
  EXPECT_EQ(folder_.read("compare.stl"), folder_.read("usual.stl"));
}

}  // namespace
}  // namespace dupin::test
