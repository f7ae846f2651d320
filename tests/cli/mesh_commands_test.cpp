#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
  EXPECT_THAT(result.out, HasSubstr("boundary_edge: 3\n"));
  const auto report = json({"check", "a.off"}, 1);
  EXPECT_EQ(report.at("counts"), (nlohmann::json{{"boundary_edge", 3}}));
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

TEST_F(MeshCommands, info_says_what_a_mesh_holds) {
  put("a.off", box({0, 0, 0}, {2, 3, 4}));
  const auto info = json({"info", "a.off"}, 0);
  EXPECT_EQ(info.at("kind"), "mesh");
  EXPECT_EQ(info.at("box"), (nlohmann::json{{0, 0, 0}, {2, 3, 4}}));
  EXPECT_EQ(info.at("check").at("volume"), 24);
  EXPECT_THAT(dupin({"info", "a.off"}).out, HasSubstr("(0, 0, 0) to (2, 3, 4)\n"));
}

TEST_F(MeshCommands, info_lists_labels) {
  const TriMesh two = joined(
      {labelled(box({0, 0, 0}, {1, 1, 1}), "left"), labelled(box({2, 0, 0}, {3, 1, 1}), "right")});
  folder_.write("a.stl", mesh_bytes(two, kStlAscii));
  EXPECT_EQ(json({"info", "a.stl"}, 0).at("names"), (nlohmann::json{"left", "right"}));
}

TEST_F(MeshCommands, info_lists_the_parts_of_a_document) {
  const auto info = json({"info", example("reducer.json")}, 0);
  EXPECT_EQ(info.at("kind"), "assembly");
  EXPECT_EQ(info.at("unit"), "mm");
  EXPECT_EQ(info.at("parts").size(), 3);
}

TEST_F(MeshCommands, union_of_crossing_boxes_has_the_exact_volume) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  const std::vector<std::pair<std::string, double>> table{
      {"union", 15}, {"intersect", 1}, {"subtract", 7}};
  for (const auto& [command, volume] : table) {
    const auto report = json({command, "a.off", "b.off", "-o", "c.off"}, 0);
    EXPECT_EQ(report.at("file"), "c.off");
    EXPECT_EQ(report.at("check").at("volume"), volume) << command;
    EXPECT_EQ(report.at("check").at("solid"), true) << command;
    EXPECT_EQ(json({"check", "c.off"}, 0), report.at("check")) << command;
  }
}

TEST_F(MeshCommands, booleans_name_the_operand_that_is_no_solid) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("open.off", open_box());
  const ProcessResult result = dupin({"union", "a.off", "open.off", "-o", "b.off"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, testing::StartsWith("dupin: 'open.off': "));
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "open.off"));
}

TEST_F(MeshCommands, contacts_are_reported_or_refused) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1, 1, 0}, {2, 2, 1}));
  const auto report = json({"union", "a.off", "b.off", "-o", "c.off"}, 0);
  ASSERT_EQ(report.at("contacts").size(), 1);
  EXPECT_EQ(report.at("contacts")[0].at("kind"), "edge");
  const ProcessResult refused =
      dupin({"union", "a.off", "b.off", "-o", "d.off", "--contacts", "refuse"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "b.off", "c.off"));
}

TEST_F(MeshCommands, stl_is_refused_for_contacts_that_its_readers_would_weld) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1, 1, 0}, {2, 2, 1}));
  const ProcessResult result = dupin({"union", "a.off", "b.off", "-o", "c.stl"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err,
            "dupin: c.stl: the solid touches itself in 1 place, at (1, 1, 0), and readers of STL "
            "would weld it there; write another format, or see --contacts separate=LENGTH and "
            "bridge=LENGTH\n");
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "b.off"));
}

TEST_F(MeshCommands, contacts_are_separated_or_bridged_and_told) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1, 1, 0}, {2, 2, 1}));
  const std::vector<std::pair<std::string, int>> table{{"separate", 2}, {"bridge", 1}};
  for (const auto& [policy, components] : table) {
    const auto report =
        json({"union", "a.off", "b.off", "-o", "c.stl", "--contacts", policy + "=0.125mm"}, 0);
    EXPECT_EQ(report.at("contacts").size(), 0);
    EXPECT_EQ(report.at("settled").at("policy"), policy);
    EXPECT_EQ(report.at("settled").at("length"), 0.125);
    EXPECT_EQ(report.at("settled").at("contacts")[0].at("kind"), "edge");
    EXPECT_EQ(report.at("check").at("components"), components);
  }
}

TEST_F(MeshCommands, union_takes_any_number_of_files_and_keeps_their_labels) {
  std::vector<std::string> command = {"union"};
  for (int i = 0; i < 30; ++i) {
    const std::string name = "part" + std::to_string(i);
    folder_.write(name + ".stl",
                  mesh_bytes(labelled(box({i * 0.5, 0, 0}, {i * 0.5 + 1, 1, 1}), name), kStlAscii));
    command.push_back(name + ".stl");
  }
  command.insert(command.end(), {"-o", "all.stl", "--format", "stl-ascii"});
  EXPECT_EQ(json(command, 0).at("check").at("volume"), 15.5);
  const auto names = json({"info", "all.stl"}, 0).at("names");
  EXPECT_EQ(names.size(), 30) << "every box shows some of its sides";
}

TEST_F(MeshCommands, boolean_evaluates_an_expression_of_named_files) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 0, 0}, {3, 2, 2}));
  put("c.off", box({0, 0, 0}, {1, 1, 1}));
  put("d.off", box({0, 0, 0}, {1, 2, 2}));
  const std::vector<std::pair<std::string, double>> table{
      {"(a + b) - c & d", 11}, {"((a + b) - c) & d", 3}, {"a & b & d", 0}, {"b-c - d + a", 12}};
  for (const auto& [expression, volume] : table) {
    std::vector<std::string> command = {"boolean", expression, "-o", "out.off"};
    for (const std::string name : {"a", "b", "c", "d"}) {
      if (expression.find(name) != std::string::npos) {
        command.push_back(name + "=" + name + ".off");
      }
    }
    EXPECT_EQ(json(command, 0).at("check").at("volume"), volume) << expression;
  }
}

TEST_F(MeshCommands, boolean_keeps_labels) {
  const auto put_labelled = [&](const std::string& name, const TriMesh& mesh) {
    folder_.write(name + ".stl", mesh_bytes(labelled(mesh, name), kStlAscii));
  };
  put_labelled("block", box({0, 0, 0}, {3, 3, 3}));
  put_labelled("drill", box({1, 1, -1}, {2, 2, 4}));
  put_labelled("far", box({9, 9, 9}, {10, 10, 10}));
  const std::vector<std::string> command = {"boolean",         "block - \"the drill\" - far",
                                            "block=block.stl", "the drill=drill.stl",
                                            "far=far.stl",     "-o",
                                            "out.obj"};
  (void)json(command, 0);
  EXPECT_EQ(json({"info", "out.obj"}, 0).at("names"), (nlohmann::json{"block", "drill"}));
}

TEST_F(MeshCommands, operands_are_repaired_only_when_asked) {
  const TriMesh two = joined({box({0, 0, 0}, {2, 2, 2}), reversed(box({1, 1, 1}, {3, 3, 3}))});
  put("two.off", two);
  put("c.off", box({5, 5, 5}, {6, 6, 6}));
  EXPECT_EQ(dupin({"union", "two.off", "c.off", "-o", "out.off"}).exit_code, 3);
  const auto report = json({"union", "two.off", "c.off", "-o", "out.off", "--repair"}, 0);
  EXPECT_EQ(report.at("check").at("volume"), 16);
  ASSERT_EQ(report.at("repairs").size(), 1);
  EXPECT_EQ(report.at("repairs")[0].at("file"), "two.off");
  EXPECT_EQ(report.at("repairs")[0].at("turned_faces"), 12);
  EXPECT_EQ(report.at("repairs")[0].at("united_overlaps"), true);
  EXPECT_THAT(dupin({"union", "two.off", "c.off", "-o", "out.off", "--repair"}).out,
              HasSubstr("repaired             two.off: 12 faces turned, overlaps united\n"));
}

TEST_F(MeshCommands, holes_are_not_repaired) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("open.off", open_box());
  const ProcessResult result = dupin({"union", "a.off", "open.off", "-o", "b.off", "--repair"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, testing::StartsWith(
                              "dupin: 'open.off': the mesh cannot be repaired: 3 edges are open"));
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "open.off"));
}

TEST_F(MeshCommands, an_interrupt_ends_at_once_and_leaves_no_file) {
  const ProcessResult result = shell("timeout --preserve-status -s INT 0.5 " DUPIN_TOOL
                                     " convert - out.off < <(sleep 20); echo $?; ls -A");
  EXPECT_EQ(result.out, "130\nexamples\n");
  EXPECT_EQ(result.err, "dupin: interrupted\n");
}

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

TEST_F(MeshCommands, union_fills_slits_and_says_so) {
  std::array<double, 4> heights = {0.6, 1.4, 0.6, 0.4};  // in float steps: rounding breaks the void
  for (double& height : heights) {
    height = 0.25 + height * 0x1p-25;
  }
  const std::vector<TriMesh> parts = pyramids(heights);
  put("a.off", parts[0]);
  put("b.off", parts[1]);
  const ProcessResult result = dupin({"union", "a.off", "b.off", "-o", "c.stl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("slits                1 void filled, at most "));
  const auto report = json({"union", "a.off", "b.off", "-o", "c.stl"}, 0);
  EXPECT_EQ(report.at("rounding").at("filled_slits"), 1);
  EXPECT_GT(report.at("rounding").at("slit_width"), 0);
  EXPECT_EQ(report.at("contacts").size(), 0);
  EXPECT_EQ(json({"check", "c.stl"}, 0).at("components"), 1);
  EXPECT_EQ(json({"union", "a.off", "b.off", "-o", "c.off"}, 0).at("contacts").size(), 4);
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

// What was 1 inch long must not become 1 mm long on its way through the tool.
TEST_F(MeshCommands, units_that_files_state_are_kept) {
  const TriMesh one = box({0, 0, 0}, {1, 1, 1});
  folder_.write("in.3mf", mesh_bytes(one, kThreeMf, {"in", {}}));
  folder_.write("in.off", mesh_bytes(moved(one, {0.5, 0, 0}), kOff, {"in", {}}));
  folder_.write("mm.off", mesh_bytes(one, kOff, {"mm", {}}));
  put("none.off", moved(one, {2, 0, 0}));
  const auto unit_of = [&](const std::string& file) { return json({"info", file}, 0).at("unit"); };
  (void)json({"union", "in.3mf", "in.off", "none.off", "-o", "both.3mf"}, 0);
  EXPECT_EQ(unit_of("both.3mf"), "in");
  (void)json({"simplify", "both.3mf", "simple.off", "--tolerance", "0.1mm"}, 0);
  EXPECT_EQ(unit_of("simple.off"), "in");
  const ProcessResult mixed = dupin({"union", "in.3mf", "mm.off", "-o", "mixed.off"});
  EXPECT_EQ(mixed.exit_code, 3);
  EXPECT_THAT(mixed.err, HasSubstr("mm.off"));
  EXPECT_THAT(mixed.err, HasSubstr("is in mm, but in.3mf in in; convert one of them first"));
}

TEST_F(MeshCommands, convert_snaps_to_a_grid) {
  put("a.off", moved(box({0, 0, 0}, {1, 1, 1}), {0.1, 0.2, 0.3}));
  const auto report = json({"convert", "a.off", "b.off", "--grid", "0.25"}, 0);
  EXPECT_EQ(report.at("check").at("volume"), 1);
  EXPECT_EQ(report.at("rounding").at("moved_points"), 8);
}

TEST_F(MeshCommands, simplify_leaves_fewer_triangles) {
  put("a.off", tube(10, 0, 50, 256));
  const auto before = json({"check", "a.off"}, 0);
  const auto report = json({"simplify", "a.off", "b.off", "--tolerance", "0.5mm"}, 0);
  const int left = report.at("check").at("triangles");
  EXPECT_LT(left, before.at("triangles").get<int>() / 4);
  EXPECT_EQ(report.at("simplification").at("removed_triangles"),
            before.at("triangles").get<int>() - left);
  EXPECT_LE(report.at("simplification").at("deviation"), 0.5);
  EXPECT_EQ(report.at("check").at("solid"), true);
}

TEST_F(MeshCommands, convert_writes_what_is_no_solid_as_it_is) {
  put("a.off", moved(open_box(), {0.1, 0.2, 0.3}));
  const auto report = json({"convert", "a.off", "b.stl"}, 0);
  EXPECT_EQ(report.at("check").at("solid"), false);
  EXPECT_EQ(report.at("check").at("triangles"), 11);
  EXPECT_EQ(report.at("rounding").at("moved_points"), 8);
}

}  // namespace
}  // namespace dupin::test
