#include <cmath>
#include <limits>
#include <string>

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
