#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;
using testing::Not;

using MeshCommands = Tool;

TEST_F(MeshCommands, info_says_what_a_mesh_holds) {
  put("a.off", box({0, 0, 0}, {2, 3, 4}));
  const auto info = json({"info", "a.off"}, 0);
  EXPECT_EQ(info.at("kind"), "mesh");
  EXPECT_EQ(info.at("box"), (nlohmann::json{{0, 0, 0}, {2, 3, 4}}));
  EXPECT_EQ(info.at("check").at("volume"), 24);
  EXPECT_THAT(dupin({"info", "a.off"}).out, HasSubstr("(0, 0, 0) to (2, 3, 4)\n"));
}

TEST_F(MeshCommands, info_states_no_volume_of_what_is_open) {
  put("a.off", open_box());
  const auto check = json({"info", "a.off"}, 0).at("check");
  EXPECT_TRUE(check.at("volume").is_null());
  EXPECT_TRUE(check.at("genus").is_null());
  const std::string text = dupin({"info", "a.off"}).out;
  EXPECT_THAT(text, HasSubstr("watertight           no\n"));
  EXPECT_THAT(text, HasSubstr("area "));
  EXPECT_THAT(text, Not(HasSubstr("volume")));
}

// Which is not looked at, but for faults that are found anyhow.
TEST_F(MeshCommands, info_does_not_say_whether_a_mesh_is_a_solid) {
  put("a.off", box({0, 0, 0}, {2, 3, 4}));
  put("crossing.off", joined({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}));
  for (const std::string name : {"a.off", "crossing.off"}) {
    EXPECT_TRUE(json({"info", name}, 0).at("check").at("solid").is_null()) << name;
    EXPECT_THAT(dupin({"info", name}).out, Not(HasSubstr("solid"))) << name;
  }
  put("open.off", open_box());
  EXPECT_EQ(json({"info", "open.off"}, 0).at("check").at("solid"), false);
}

// As documents, and meshes of text, begin.
TEST_F(MeshCommands, info_reads_binary_stl_whose_header_begins_like_something_else) {
  std::string stl = mesh_bytes(box({0, 0, 0}, {2, 3, 4}), kStlBinary);
  for (const std::string start : {"{\"units\": \"mm\"}", "OFFSHORE", "OFF", "ply\n"}) {
    stl.replace(0, start.size(), start);
    folder_.write("a.stl", stl);
    EXPECT_EQ(json({"info", "a.stl"}, 0).at("kind"), "mesh") << start;
    EXPECT_EQ(json({"info", "a.stl"}, 0).at("check").at("volume"), 24) << start;
  }
}

TEST_F(MeshCommands, info_lists_labels) {
  const TriMesh two = joined(
      {labelled(box({0, 0, 0}, {1, 1, 1}), "left"), labelled(box({2, 0, 0}, {3, 1, 1}), "right")});
  folder_.write("a.stl", mesh_bytes(two, kStlAscii));
  EXPECT_EQ(json({"info", "a.stl"}, 0).at("names"), (nlohmann::json{"left", "right"}));
}

TEST_F(MeshCommands, info_lists_no_label_that_no_triangle_has) {
  TriMesh two = joined(
      {labelled(box({0, 0, 0}, {1, 1, 1}), "left"), labelled(box({2, 0, 0}, {3, 1, 1}), "right")});
  two.names = {"none", "left", "", "right"};
  for (std::uint32_t& label : two.labels) {
    label = 2 * label + 1;
  }
  folder_.write("a.ply", mesh_bytes(two, kPlyBinary));
  EXPECT_EQ(json({"info", "a.ply"}, 0).at("names"), (nlohmann::json{"left", "right"}));
  const std::string text = dupin({"info", "a.ply"}).out;
  EXPECT_THAT(text, HasSubstr("label                left\nlabel                right\n"));
  EXPECT_THAT(text, Not(HasSubstr("none")));
}

TEST_F(MeshCommands, info_lists_the_parts_of_a_document) {
  const auto info = json({"info", example("reducer.json")}, 0);
  EXPECT_EQ(info.at("kind"), "assembly");
  EXPECT_EQ(info.at("unit"), "mm");
  EXPECT_EQ(info.at("parts").size(), 3);
}

TEST_F(MeshCommands, info_says_what_becomes_of_a_graph) {
  const auto frame = json({"info", example("frame.graph"), "--radius", "2cm", "--unit", "cm"}, 0);
  EXPECT_EQ(frame.at("unit"), "cm");
  EXPECT_GT(frame.at("parts").size(), 5);
  const ProcessResult text = dupin({"info", "-"}, "1 0 0 0 0 2 -1\n2 0 0 0 50 2 1\n");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("2 nodes, 1 edge, 1 component, 0 cycles"));
  EXPECT_THAT(text.out, HasSubstr("edge 1-2: pipe"));
  EXPECT_EQ(dupin({"info", example("tee.json"), "--unit", "cm"}).exit_code, 2);
  EXPECT_EQ(dupin({"info", example("frame.graph"), "--unit", "mile"}).exit_code, 2);
}

TEST_F(MeshCommands, info_of_an_empty_document_does_not_ask_for_a_mesh) {
  folder_.write("a.json", "");
  for (const std::string command : {"info", "gaps"}) {
    const ProcessResult empty = dupin({command, "a.json"});
    EXPECT_EQ(empty.exit_code, 3);
    EXPECT_THAT(empty.err, HasSubstr("a.json:1:1: syntax error"));
    EXPECT_THAT(empty.err, testing::Not(HasSubstr("mesh")));
  }
}

// Of a document that nothing else takes, too.
TEST_F(MeshCommands, info_shows_names_on_one_line_without_control_characters) {
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "a\nb\u001b[31m\u007f", "sphere": {"center": [0, 0, 0], "radius": 1}}]})");
  const ProcessResult document = dupin({"info", "a.json"});
  EXPECT_EQ(document.exit_code, 0) << document.err;
  EXPECT_THAT(document.out, HasSubstr("\n  a\\x0ab\\x1b[31m\\x7f: sphere\n"));
}

}  // namespace
}  // namespace dupin::test
