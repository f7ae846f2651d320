#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using Watch = Tool;

// Waits for up to ten seconds until a command succeeds.
const std::string kPrelude =
    "until_() { for i in $(seq 200); do eval \"$1\" && return 0; sleep 0.05; done; return 1; }; "
    "sphere() { echo '{\"units\": \"mm\", \"tolerance\": 0.1, \"parts\": [{\"name\": \"a\", "
    "\"sphere\": {\"center\": [0, 0, 0], \"radius\": '$1'}}]}' > new; mv new a.json; }; ";

TEST_F(Watch, ends_where_no_change_of_the_document_would_help) {
  const ProcessResult result =
      shell(kPrelude + "sphere 1; timeout 20 " + tool_path() + " watch a.json -o a.obj --tiles 2");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, testing::HasSubstr("binary PLY and .pvtu files only"));
  EXPECT_THAT(result.err, testing::Not(testing::HasSubstr("waiting")));
}

TEST_F(Watch, builds_again_when_the_document_changes_and_goes_on_after_errors) {
  const ProcessResult result = shell(
      kPrelude + "sphere 1; " + tool_path() +
      " watch a.json -o a.off > out 2> err & pid=$!; "
      "until_ '[ -e a.off ]' || exit 10; cp a.off first; "
      "sphere -1; until_ 'grep -q radius err' || exit 11; cmp -s a.off first || exit 12; "
      "sphere 2; until_ '! cmp -s a.off first' || exit 13; "
      "rm a.json; until_ 'grep -q \"is gone\" err' || exit 14; cp a.off second; "
      "sphere 1; until_ 'cmp -s a.off first' || exit 15; "
      "kill -0 $pid || exit 16; kill -TERM $pid; wait $pid; [ $? = 143 -o $? = 130 ] || exit 17; "
      "grep -c written out; ls -A | tr '\\n' ' '");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("err") << folder_.read("out");
  EXPECT_EQ(result.out, "3\na.json a.off err examples first out second ");
}

// As build does; it took meshes of surfaces only.
TEST_F(Watch, writes_all_formats) {
  for (const std::string name : {"a.pvtu", "a.ply"}) {
    const ProcessResult result =
        shell(kPrelude + "sphere 1; " + tool_path() + " watch a.json -o " + name +
              " --cache kept > out 2> err & pid=$!; until_ 'grep -q written out' || exit 10; "
              "kill -TERM $pid; wait $pid; [ -s " +
              name + " ]");
    EXPECT_EQ(result.exit_code, 0) << name << folder_.read("err");
  }
}

// The document is written in place and its time set back, as by tools that copy and unpack files.
TEST_F(Watch, sees_changes_that_leave_size_and_time_as_they_were) {
  const ProcessResult result =
      shell(kPrelude + "sphere 1; touch -d '2020-01-01 12:00' a.json; " + tool_path() +
            " watch a.json -o a.off > out 2> err & pid=$!; "
            "until_ '[ -e a.off ]' || exit 10; cp a.off first; "
            "until_ 'grep -q waiting err' || exit 11; "
            "sphere 2; cat a.json > b.json; sphere 1; touch -d '2020-01-01 12:00' a.json; "
            "until_ 'cmp -s a.off first' || exit 12; sleep 0.3; "
            "cat b.json > a.json; touch -d '2020-01-01 12:00' a.json; "
            "until_ '! cmp -s a.off first' || exit 13; "
            "kill -TERM $pid; wait $pid; true");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("err") << folder_.read("out");
}

// What changes of the file is not always what is in it.
TEST_F(Watch, does_not_build_for_a_change_of_permissions) {
  const ProcessResult result =
      shell(kPrelude + "sphere 1; " + tool_path() +
            " watch a.json -o a.off > out 2> err & pid=$!; "
            "until_ 'grep -q waiting err' || exit 10; chmod 600 a.json; sleep 1; "
            "kill -TERM $pid; wait $pid; grep -c written out");
  EXPECT_EQ(result.out, "1\n") << result.err << folder_.read("err");
}

TEST_F(Watch, builds_again_when_a_mesh_that_the_document_avoids_changes) {
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "values": {"mf": "m.off"}, "parts": [
      {"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
      {"name": "b", "pipe": {"from": [60, 0, 0], "to": [61, 0, 0], "radius": 1}},
      {"name": "r", "spline": {"from": "a.end", "to": "b.start", "through": [], "clearance": 1,
                               "avoid": [{"mesh": "=mf"}]}},
      {"name": "c", "pipe": {"from": [0, 40, 0], "to": [1, 40, 0], "radius": 1}},
      {"name": "d", "pipe": {"from": [60, 40, 0], "to": [61, 40, 0], "radius": 1}},
      {"for": {"i": 1}, "parts": [
          {"name": "s{i}", "spline": {"from": "c.end", "to": "d.start", "through": [],
                                      "clearance": 1, "avoid": [{"mesh": "k{i}.off"}]}}]}]})");
  put("k0.off", box({25, 50, -1}, {30, 52, 1}));
  put("m.off", box({25, -1, -1}, {30, 1, 1}));
  put("n.off", box({25, -1, -1}, {30, 6, 1}));
  const ProcessResult result =
      shell(kPrelude + tool_path() +
            " watch a.json -o a.off > out 2> err & pid=$!; "
            "until_ 'grep -q waiting err' || exit 10; cp a.off first; cp m.off m; "
            "mv n.off m.off; until_ '! cmp -s a.off first' || exit 11; "
            "rm m.off; until_ 'grep -q m.off err' || exit 12; "
            "cp m m.off; until_ 'cmp -s a.off first' || exit 13; "
            "mv k0.off k; until_ 'grep -q k0.off err' || exit 14; "
            "rm a.off; mv k k0.off; until_ 'cmp -s a.off first' || exit 15; "
            "kill -TERM $pid; wait $pid; true");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("err") << folder_.read("out");
}

TEST_F(Watch, waits_for_a_document_that_is_not_there_yet) {
  const ProcessResult result =
      shell(kPrelude + tool_path() +
            " watch a.json -o a.off > out 2> err & pid=$!; "
            "until_ 'grep -q \"there is no a.json yet\" err' || exit 10; kill -0 $pid || exit 11; "
            "sphere 1; until_ '[ -e a.off ]' || exit 12; kill -TERM $pid; wait $pid; true");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("err") << folder_.read("out");
}

TEST_F(Watch, prints_an_object_a_line_with_json) {
  const ProcessResult result = shell(kPrelude + tool_path() +
                                     " watch a.json -o a.off --json > out 2> err & pid=$!; "
                                     "until_ 'grep -q missing out' || exit 10; "
                                     "sphere 1; until_ 'grep -q waiting out' || exit 11; "
                                     "sphere -1; until_ 'grep -q failure out' || exit 12; "
                                     "rm a.json; until_ 'grep -q gone out' || exit 13; [ ! -s err "
                                     "] || exit 14; kill -TERM $pid; wait $pid; true");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("out");
  std::istringstream lines(folder_.read("out"));
  std::vector<nlohmann::json> said;
  for (std::string line; std::getline(lines, line);) {
    said.push_back(nlohmann::json::parse(line));
    EXPECT_EQ(said.back().at("file"), "a.json");
  }
  ASSERT_EQ(said.size(), 6U);
  EXPECT_EQ(said[0].at("state"), "missing");
  EXPECT_EQ(said[1].at("output"), "a.off");
  EXPECT_EQ(said[1].at("report").at("parts").size(), 1U);
  EXPECT_EQ(said[2].at("state"), "waiting");
  EXPECT_EQ(said[3].at("failure").at("error").at("code"), "invalid_argument");
  EXPECT_EQ(said[5].at("state"), "gone");
}

TEST_F(Watch, needs_files) {
  EXPECT_EQ(dupin({"watch", "-", "-o", "a.stl"}).exit_code, 2);
  EXPECT_EQ(dupin({"watch", example("reducer.json"), "-o", "a.txt"}).exit_code, 2);
}

}  // namespace
}  // namespace dupin::test
