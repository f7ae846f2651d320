#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Gaps = Tool;

std::string two_pipes(const std::string& second_start) {
  return R"({"units": "mm", "tolerance": 0.01, "parts": [
    {"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
    {"name": "b", "pipe": {"from": [)" +
         second_start + R"(, 0, 0], "to": [8, 0, 0], "radius": 1}}]})";
}

TEST_F(Gaps, shared_ends_are_welded) {
  const auto summary = json({"gaps", example("reducer.json")}, 0);
  EXPECT_EQ(summary.at("findings"), 0);
  std::size_t welded = 0;
  for (const auto& pair : summary.at("pairs")) {
    welded += pair.at("verdict") == "welded" ? 1 : 0;
  }
  EXPECT_EQ(welded, 2);
}

TEST_F(Gaps, one_ulp_is_a_gap) {
  folder_.write("a.json", two_pipes("1.0000000000000002"));
  const auto summary = json({"gaps", "a.json"}, 1);
  ASSERT_EQ(summary.at("findings"), 1);
  for (const auto& pair : summary.at("pairs")) {
    if (pair.at("verdict") == "gap") {
      EXPECT_EQ(pair.at("from"), "a.end");
      EXPECT_EQ(pair.at("to"), "b.start");
      EXPECT_EQ(pair.at("exact").at("axial_dot"), "1/4503599627370496");
      EXPECT_EQ(pair.at("axial").at("lower"), std::numeric_limits<double>::epsilon());
      EXPECT_EQ(pair.at("axial").at("upper"), std::numeric_limits<double>::epsilon());
    }
  }
  EXPECT_THAT(dupin({"gaps", "a.json"}).out,
              HasSubstr("gap: a.end to b.start: axial 2.22044605e-16 mm\n"));
}

TEST_F(Gaps, connect_decides_what_belongs_together) {
  folder_.write("a.json", two_pipes("1.5"));
  EXPECT_EQ(json({"gaps", "a.json"}, 0).at("connect"), 0.01);
  EXPECT_EQ(json({"gaps", "a.json", "--connect", "0.05cm"}, 1).at("findings"), 1);
  EXPECT_EQ(json({"gaps", "a.json", "--connect", "0.4"}, 0).at("findings"), 0);
}

TEST_F(Gaps, branches_that_start_at_one_place_of_their_run_fit) {
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.01, "parts": [
    {"name": "run", "pipe": {"from": [0, 0, 0], "to": [20, 0, 0], "radius": 2}},
    {"name": "a", "pipe": {"on": "run", "at": 10, "direction": [0, 1, 0], "length": 5, "radius": 1}},
    {"name": "b", "pipe": {"on": "run", "at": 10, "direction": [0, -1, 1], "length": 5, "radius": 1}}
  ]})");
  const auto summary = json({"gaps", "a.json"}, 0);
  EXPECT_EQ(summary.at("findings"), 0);
  EXPECT_EQ(summary.at("pairs").size(), 4U);
}

/// Pipes of radius 1 from the origin to these places, and what is about it.
std::string star(const std::vector<std::string>& to, const std::string& more = {}) {
  std::string text = R"({"units": "mm", "tolerance": 0.01, "parts": [)";
  for (std::size_t i = 0; i < to.size(); ++i) {
    text += (i == 0 ? "" : ", ") + (R"({"name": "p)" + std::to_string(i)) +
            R"(", "pipe": {"from": [0, 0, 0], "to": [)" + to[i] + R"(], "radius": 1}})";
  }
  return text + more + "]}";
}

// At 89.9 and at 90 degrees alike.
TEST_F(Gaps, ends_that_meet_at_a_right_angle_have_a_kink) {
  folder_.write("a.json", star({"-9, 0, 0", "0, 9, 0"}));
  const auto summary = json({"gaps", "a.json"}, 1);
  EXPECT_EQ(summary.at("findings"), 1);
  EXPECT_EQ(summary.at("pairs").at(0).at("verdict"), "kink");
  EXPECT_EQ(summary.at("pairs").at(0).at("to"), "p1.start");
  EXPECT_THAT(dupin({"gaps", "a.json"}).out,
              HasSubstr("kink: p0.start to p1.start: kink 1.57079633 rad\n"));
  EXPECT_EQ(json({"build", "a.json", "-o", "a.off"}, 1).at("gaps").at("findings"), 1);
}

TEST_F(Gaps, ends_that_start_in_a_third_part_face_nothing) {
  const std::string
      ball = R"(, {"name": "ball", "sphere": {"center": [0, 0, 0], "radius": 1}})",
      header = R"(, {"name": "header",
                      "pipe": {"from": [0, 0, -20], "to": [0, 0, 20], "radius": 1}})",
      halves = R"(, {"name": "up", "pipe": {"from": [0, 0, 0], "to": [0, 0, 20], "radius": 1}},
                      {"name": "down", "pipe": {"from": [0, 0, -20], "to": [0, 0, 0], "radius": 1}})";
  for (const std::string& third : {ball, header, halves}) {
    folder_.write("a.json", star({"-9, 0, 0", "0, 9, 0"}, third));
    EXPECT_EQ(json({"gaps", "a.json"}, 0).at("findings"), 0) << third;
    EXPECT_EQ(json({"build", "a.json", "-o", "a.off"}, 0).at("gaps").at("findings"), 0);
  }
  folder_.write("a.json", star({"-9, 0, 0", "0, 9, 0", "0, 0, 9"}));
  EXPECT_EQ(json({"gaps", "a.json"}, 0).at("findings"), 0);
  folder_.write("a.json", star({"9, 0, 0", "9, 1, 0"}));
  EXPECT_EQ(json({"gaps", "a.json"}, 0).at("findings"), 0) << "side by side";
}

TEST_F(Gaps, of_a_piping_file_are_where_it_is_blended) {
  folder_.write("a.pcf",
                "UNITS-BORE MM\nUNITS-CO-ORDS MM\n"
                "PIPE\n END-POINT 0 0 0 100\n END-POINT 900 0 0 100\n"
                "PIPE\n END-POINT 900 0 0.02 100\n END-POINT 800 500 0 100\n");
  const auto summary = json({"gaps", "a.pcf"}, 1);
  ASSERT_EQ(summary.at("findings"), 1);
  const auto joints =
      json({"build", "a.pcf", "-o", "a.off", "--bore", "outside"}, 0).at("piping").at("joints");
  ASSERT_EQ(joints.size(), 1);
  for (const auto& pair : summary.at("pairs")) {
    if (pair.at("verdict") != "open") {
      EXPECT_NEAR(pair.at("kink").at("lower"), joints[0].at("kink"), 1e-12);
    }
  }
}

const std::string kPiping =
    "UNITS-BORE MM\nUNITS-CO-ORDS MM\n"
    "PIPE\n END-POINT 0 0 0 114.3\n END-POINT 1000 0 0 114.3\n"
    "PIPE\n END-POINT 1000.3 0 0 114.3\n END-POINT 2000 0 0 114.3\n";

// As `build` refuses it, or says what it left out or did not understand.
TEST_F(Gaps, of_a_piping_file_leave_nothing_out_in_silence) {
  for (const auto& [bad, code] : std::vector<std::pair<std::string, int>>{
           {" END-POINT 2500 0 0 114.3\n", 3},
           {"ELBOW\n END-POINT 3000 0 0 114.3\n END-POINT 3300 300 0 114.3\n", 3},
           {"PIPE\n END-POINT 4000 0 0\n END-POINT 4500 0 0\n", 3},
           {"ELBOW\n END-POINT 3000 0 0 114.3\n END-POINT 3030 30 0 114.3\n"
            " CENTRE-POINT 3030 0 0\n",
            4}}) {
    folder_.write("a.pcf", kPiping + bad);
    const ProcessResult built = dupin({"build", "a.pcf", "-o", "a.off"}),
                        refused = dupin({"gaps", "a.pcf"});
    EXPECT_EQ(refused.exit_code, code) << bad;
    EXPECT_EQ(built.exit_code, code) << bad;
    EXPECT_EQ(refused.err, built.err);
    EXPECT_THAT(refused.err, HasSubstr("--keep-going leaves it out"));
    EXPECT_THAT(dupin({"gaps", "a.pcf", "--keep-going"}).out,
                HasSubstr("refused              line "));
    const auto kept = json({"gaps", "a.pcf", "--keep-going"}, 1);
    const auto& notes = kept.at("source").at("notes");
    ASSERT_EQ(notes.size(), 1);
    EXPECT_TRUE(notes[0].at("refused"));
    const bool is_second = notes[0].at("line") == 6;
    EXPECT_EQ(kept.at("findings"), is_second ? 1 : 2) << "and the gap";
    EXPECT_EQ(kept.at("pairs").size(), is_second ? 2 : 3);
  }
}

TEST_F(Gaps, of_a_piping_file_say_what_is_not_understood) {
  folder_.write("a.pcf", kPiping + "FOO-VALVE\n END-POINT 2000 0 0 114.3\n END-POINT 2100 0 0\n");
  EXPECT_THAT(dupin({"gaps", "a.pcf"}).out,
              HasSubstr("warning              line 9: 'FOO-VALVE' is not understood\n"));
  EXPECT_EQ(json({"gaps", "a.pcf"}, 1).at("source").at("not_understood").size(), 1);
}

// The pipe between takes its neighbours' bore, as in `build`.
TEST_F(Gaps, of_a_piping_file_have_ends_without_a_bore) {
  folder_.write("a.pcf", kPiping + "PIPE\n END-POINT 2000 0 0\n END-POINT 2500 0 0\n");
  const auto summary = json({"gaps", "a.pcf"}, 1);
  EXPECT_EQ(summary.at("pairs").size(), 4);
  EXPECT_EQ(summary.at("findings"), 1);
  EXPECT_EQ(summary.at("source").at("notes").size(), 1);
}

TEST_F(Gaps, of_a_graph_say_what_was_left_out) {
  folder_.write("a.graph", "n 0 0 0\nn 9 0 0\nc 0 1\nc 0 7\n");
  EXPECT_EQ(dupin({"gaps", "a.graph", "--radius", "1"}).exit_code, 3);
  const auto kept = json({"gaps", "a.graph", "--radius", "1", "--keep-going"}, 1);
  EXPECT_EQ(kept.at("findings"), 1);
  EXPECT_TRUE(kept.at("source").at("notes").at(0).at("refused"));
}

TEST_F(Gaps, meshes_apart_leave_a_slit) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1 + 1.0 / 1024, 0, 0}, {2, 1, 1}));
  const auto summary = json({"gaps", "a.off", "b.off"}, 1);
  ASSERT_EQ(summary.at("facing").size(), 1);
  EXPECT_EQ(summary.at("facing")[0].at("least_squared"), "1/1048576");
  EXPECT_EQ(summary.at("facing")[0].at("least").at("lower"), 1.0 / 1024);
  EXPECT_EQ(summary.at("components"), 2);
  const ProcessResult text = dupin({"gaps", "a.off", "b.off"});
  EXPECT_THAT(text.out, HasSubstr("slits                1\n"));
  EXPECT_THAT(text.out, HasSubstr("union                2 components\n"));
}

TEST_F(Gaps, meshes_that_share_a_face_are_one) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1, 0, 0}, {2, 1, 1}));
  const auto summary = json({"gaps", "a.off", "b.off"}, 0);
  EXPECT_EQ(summary.at("findings"), 0);
  EXPECT_EQ(summary.at("welded_faces"), 2);
  EXPECT_EQ(summary.at("components"), 1);
}

TEST_F(Gaps, boundary_loops_of_one_mesh_are_found) {
  put("a.off", open_box());
  const auto summary = json({"gaps", "a.off"}, 1);
  ASSERT_EQ(summary.at("boundary_a").size(), 1);
  EXPECT_EQ(summary.at("boundary_a")[0].at("points").size(), 3);
  EXPECT_THAT(dupin({"gaps", "a.off"}).out,
              HasSubstr("boundary of a.off: 3 points, length 3.41421356"));
}

TEST_F(Gaps, documents_and_meshes_do_not_mix) {
  put("a.off", open_box());
  EXPECT_EQ(dupin({"gaps", "a.off", example("reducer.json")}).exit_code, 2);
}

TEST_F(Gaps, of_a_graph_are_none) {
  const auto frame = json({"gaps", example("frame.graph"), "--radius", "2"}, 0);
  EXPECT_EQ(frame.at("findings"), 0);
  EXPECT_GT(frame.at("pairs").size(), 5);
  EXPECT_EQ(dupin({"gaps", "-", "--radius", "1"}, "n 0 0 0\nn 9 0 0\nc 0 1\n").exit_code, 0);
}

}  // namespace
}  // namespace dupin::test
