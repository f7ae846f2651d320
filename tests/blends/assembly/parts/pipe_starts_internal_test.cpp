#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/parts/pipe_starts.h"
#include "io/json/facing_pipes.h"

namespace dupin::assembly {
namespace {

using test::refusal;
using testing::HasSubstr;
using testing::Not;

std::string document(const std::string& parts) {
  return R"({"units": "mm", "tolerance": 0.05, "parts": [)" + parts + "]}";
}

std::string tee(const std::string& from, const std::string& length, const std::string& branch,
                const std::string& fillet = "2") {
  return R"({"name": "t", "tee": {"from": )" + from + R"(, "length": )" + length +
         R"(, "fillet": )" + fillet + R"(, "branch": {"direction": [0, 0, 1], "length": 30, )" +
         branch + "}}}";
}

const std::string kPoint = R"([0, 0, 0], "direction": [1, 0, 0], "radius": 5)";

// The number after the last of these words.
std::string number_after(const std::string& why, const std::string& words) {
  const std::size_t found = why.rfind(words);
  EXPECT_NE(found, std::string::npos) << why;
  std::smatch number;
  const std::string rest = found == std::string::npos ? "" : why.substr(found + words.size());
  return std::regex_search(rest, number, std::regex("^[0-9.]+")) ? number[0].str() : "0";
}

TEST(PipeStarts, tell_a_tee_and_the_ports_of_its_run) {
  const Assembly parsed = parse_assembly(
      document(R"({"name": "a", "pipe": {"from": [-9, 0, 0], "to": [0, 0, 0], "radius": 5}}, )" +
               tee(R"("a.end")", "40", R"("radius": 3, "at": 15)")));
  const PipeStarts starts = pipe_starts(parsed, {1, 2});
  EXPECT_EQ(starts.joined.at(0).at(0), "a.end");
  EXPECT_EQ(starts.joined.at(0).at(1), "");
  ASSERT_TRUE(starts.on);
  EXPECT_EQ(starts.on->branch, 1);
  EXPECT_EQ(starts.on->at, 15);
  EXPECT_EQ(starts.on->tee, "t");
  EXPECT_EQ(starts.on->run_length, 40);
  EXPECT_FALSE(pipe_starts(parsed, {0, 1}).on);
}

// The branch of a tee begins on the run's axis: it has no start that could be moved.
TEST(PipeStarts, a_tee_whose_branch_is_to_begin_elsewhere_is_no_tee) {
  const std::string why = refusal(document(R"({"name": "t", "tee": {"from": )" + kPoint +
                                           R"(, "length": 60, "fillet": 1,
                       "branch": {"direction": [0, 0, 1], "length": 30, "radius": 6}}})"));
  EXPECT_THAT(why, HasSubstr("; with 't' written as pipes from points and a fillet, and 't-branch' "
                             "longer by "));
  const double more = std::stod(number_after(why, "'t-branch' longer by "));
  EXPECT_EQ(refusal(document(R"(
    {"name": "t", "pipe": {"from": [0, 0, 0], "to": [60, 0, 0], "radius": 5}},
    {"name": "b", "pipe": {"from": [30, 0, )" +
                             std::to_string(-more) + R"(], "to": [30, 0, 30], "radius": 6}},
    {"name": "f", "fillet": {"between": ["t", "b"], "radius": 1}})")),
            "none");
}

TEST(PipeStarts, a_tee_is_made_longer_by_its_own_keys) {
  const std::string before =
      R"({"name": "a", "pipe": {"from": [-9, 0, 0], "to": [0, 0, 0], "radius": 5}}, )";
  for (const std::string& from : {kPoint, std::string(R"("a.end")")}) {
    for (const std::string& at :
         {std::string(), std::string(R"(, "at": 2)"), std::string(R"(, "at": 6)")}) {
      const std::string why = refusal(document(before + tee(from, "7", R"("radius": 4)" + at)));
      EXPECT_THAT(why, Not(HasSubstr(" at its ")));
      const std::string length = number_after(why, R"(a "length" of )"),
                        further = number_after(why, R"('t' and its branch "at" )");
      const std::string ball =
          why.ends_with(" the ball would fit") ? "2" : number_after(why, " a ball of radius ");
      EXPECT_EQ(
          refusal(document(before + tee(from, length, R"("radius": 4, "at": )" + further, ball))),
          "none")
          << why;
    }
  }
}

TEST(PipeStarts, a_branch_on_a_pipe_is_measured_from_where_that_begins) {
  const auto branch = [](const std::string& run, const std::string& at) {
    return document(R"({"name": "r", "pipe": {"from": [)" + run +
                    R"(, 0, 0], "to": [40, 0, 0], "radius": 5}},
      {"name": "b", "pipe": {"on": "r", "at": )" +
                    at +
                    R"(, "direction": [0, 0, 1], "length": 30, "radius": 4}},
      {"name": "f", "fillet": {"between": ["r", "b"], "radius": 2}})");
  };
  const std::string why = refusal(branch("0", "3"));
  const double more = std::stod(number_after(why, "'r' longer by "));
  EXPECT_EQ(refusal(branch(std::to_string(-more), number_after(why, R"('b' "at" )"))), "none")
      << why;
}

TEST(PipeStarts, a_branch_that_is_to_begin_elsewhere_is_not_on_the_pipe) {
  const auto branch = [](const std::string& start) {
    return document(R"({"name": "r", "pipe": {"from": [0, 0, 0], "to": [40, 0, 0], "radius": 5}},
      {"name": "b", "pipe": {)" +
                    start + R"(, "direction": [0, 0, 1], "radius": 6, "length": )" +
                    (start.front() == '"' && start[1] == 'o' ? "30" : "60") + R"(}},
      {"name": "f", "fillet": {"between": ["r", "b"], "radius": 1}})");
  };
  const std::string why = refusal(branch(R"("on": "r", "at": 20)"));
  EXPECT_THAT(why, HasSubstr("'b' from a point, not \"on\" 'r', and 'b' longer by "));
  const double more = std::stod(number_after(why, "'b' longer by "));
  EXPECT_EQ(refusal(branch(R"("from": [20, 0, )" + std::to_string(-more) + "]")), "none") << why;
}

TEST(PipeStarts, a_pipe_at_a_port_is_said_to_begin_there) {
  const std::string why = refusal(document(R"(
    {"name": "a", "pipe": {"from": [-9, 0, 0], "to": [0, 0, 0], "radius": 5}},
    {"name": "r", "pipe": {"from": "a.end", "length": 40}},
    {"name": "b", "pipe": {"from": [3, 0, 0], "to": [3, 0, 30], "radius": 4}},
    {"name": "f", "fillet": {"between": ["r", "b"], "radius": 2}})"));
  EXPECT_THAT(why, HasSubstr(" at its start, which is at 'a.end', the ball would fit"));
}

}  // namespace
}  // namespace dupin::assembly
