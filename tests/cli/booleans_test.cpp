#include <algorithm>
#include <array>
#include <string>
#include <utility>
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

TEST_F(MeshCommands, timing_is_in_the_report_only_where_it_is_asked_for) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  const auto plain = json({"union", "a.off", "b.off", "-o", "c.off"}, 0);
  EXPECT_FALSE(plain.contains("timing"));
  auto timed = json({"union", "a.off", "b.off", "-o", "c.off", "--timing"}, 0);
  std::vector<std::string> stages;
  for (const auto& stage : timed.at("timing")) {
    stages.push_back(stage.at("stage"));
    EXPECT_GE(stage.at("wall"), 0) << stages.back();
    EXPECT_GE(stage.at("processor"), 0) << stages.back();
  }
  EXPECT_THAT(stages, ElementsAre("read", "prove", "load", "search", "intersect", "triangulate",
                                  "classify", "extract", "round", "measure", "write", "verify"));
  timed.erase("timing");
  EXPECT_EQ(timed, plain);
}

TEST_F(MeshCommands, timing_goes_to_standard_error_beside_a_text) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  const ProcessResult plain = dupin({"subtract", "a.off", "b.off", "-o", "c.off"});
  const ProcessResult timed = dupin({"subtract", "a.off", "b.off", "-o", "c.off", "--timing"});
  EXPECT_EQ(plain.err, "");
  EXPECT_EQ(timed.out, plain.out);
  EXPECT_THAT(timed.err, testing::StartsWith("read  "));
  EXPECT_THAT(timed.err, HasSubstr("\nmeasure  "));
  EXPECT_THAT(timed.err, HasSubstr("\nverify  "));
  const ProcessResult unread =
      dupin({"subtract", "a.off", "b.off", "-o", "quiet.off", "-q", "--timing"});
  EXPECT_EQ(unread.out, "");
  EXPECT_THAT(unread.err, testing::Not(HasSubstr("\nmeasure  ")));
  EXPECT_THAT(unread.err, HasSubstr("\nverify  "));
  EXPECT_EQ(shell("cmp quiet.off c.off").exit_code, 0);
  const ProcessResult unverified = dupin(
      {"union", "a.off", "b.off", "-o", "-", "--format", "off", "-q", "--no-verify", "--timing"});
  EXPECT_THAT(unverified.err, HasSubstr("\nwrite  "));
  EXPECT_THAT(unverified.err, testing::Not(HasSubstr("\nverify  ")));
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
  const ProcessResult result =
      dupin({"union", "a.off", "b.off", "-o", "c.stl", "--contacts", "report"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err,
            "dupin: c.stl: the solid touches itself in 1 place, at (1, 1, 0), and readers of STL "
            "would weld it there; write another format, or see --contacts separate=LENGTH and "
            "bridge=LENGTH\n");
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "b.off"));
}

// The numbers of STL do not tell it from the corner that it touches.
TEST_F(MeshCommands, contacts_of_what_rounding_removes_are_not_told) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", tetrahedron({1, 1, 1}, 0x1p-30));
  EXPECT_EQ(json({"union", "a.off", "b.off", "-o", "c.off"}, 0).at("contacts").size(), 1);
  const auto report = json({"union", "a.off", "b.off", "-o", "c.stl", "--contacts", "report"}, 0);
  EXPECT_TRUE(report.at("contacts").empty());
  EXPECT_EQ(report.at("rounding").at("removed_shells"), 1);
}

TEST_F(MeshCommands, stl_is_parted_at_contacts_by_what_its_numbers_can_hold) {
  const Vec3 far(1234567.25, 345678.125, 98765.5);  // where binary32 has a spacing of 0.125
  put("a.off", box(far, far + Vec3(100, 100, 100)));
  put("edge.off", box(far + Vec3(100, 100, 0), far + Vec3(200, 200, 100)));
  put("point.off", box(far + Vec3(100, 100, 100), far + Vec3(200, 200, 200)));
  for (const std::string other : {"edge.off", "point.off"}) {
    const auto report = json({"union", "a.off", other, "-o", "c.stl"}, 0);
    EXPECT_TRUE(report.at("contacts").empty());
    EXPECT_EQ(report.at("settled").at("policy"), "separate");
    EXPECT_EQ(report.at("settled").at("contacts").size(), 1);
    EXPECT_LE(report.at("settled").at("length"), 8.0);
    EXPECT_EQ(report.at("check").at("components"), 2);
    EXPECT_NEAR(report.at("check").at("volume"), 2e6, 2e6 * 0.01);
  }
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

// Two that cross, and two by themselves, one of which is larger than all.
TEST_F(MeshCommands, unions_have_the_same_bytes_in_whatever_order_operands_are_given) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  put("c.off", box({-5, 0, 0}, {-4, 1, 1}));
  put("d.off", box({5, -9, -9}, {9, 9, 9}));
  for (const std::string out : {"out.off", "out.stl", "out.ply", "out.glb", "out.3mf"}) {
    std::vector<std::string> files{"a.off", "b.off", "c.off", "d.off"};
    std::string first;
    do {
      std::vector<std::string> command{"union", "-o", out};
      command.insert(command.end(), files.begin(), files.end());
      EXPECT_EQ(json(command, 0).at("check").at("components"), 3);
      first = first.empty() ? folder_.read(out) : first;
      EXPECT_TRUE(folder_.read(out) == first) << out << ": " << files[0] << " " << files[1];
    } while (std::ranges::next_permutation(files).found);
  }
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

TEST_F(MeshCommands, union_fills_slits_and_says_so) {
  std::array<double, 4> heights = {0.6, 1.4, 0.6, 0.4};  // in float steps: rounding breaks the void
  for (double& height : heights) {
    height = 0.25 + height * 0x1p-25;
  }
  const std::vector<TriMesh> parts = pyramids(heights);
  put("a.off", parts[0]);
  put("b.off", parts[1]);
  // Otherwise the edges where they touch are separated first, by one spacing, and the void is open.
  const std::vector<std::string> command = {"union", "a.off",      "b.off", "-o",
                                            "c.stl", "--contacts", "report"};
  const ProcessResult result = dupin(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("slits                1 filled, at most "));
  const auto report = json(command, 0);
  EXPECT_EQ(report.at("rounding").at("filled_slits"), 1);
  EXPECT_GT(report.at("rounding").at("slit_width"), 0);
  EXPECT_EQ(report.at("contacts").size(), 0);
  EXPECT_EQ(json({"check", "c.stl"}, 0).at("components"), 1);
  EXPECT_EQ(json({"union", "a.off", "b.off", "-o", "c.off"}, 0).at("contacts").size(), 4);
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
  EXPECT_THAT(mixed.err,
              HasSubstr("is in mm, but in.3mf in in; convert one of them first, with --to-unit"));
}

}  // namespace
}  // namespace dupin::test
