#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::pipe_and;
using test::read_last;

TEST(SplineKey, reads_its_points) {
  const auto open = read_last<SplineBetween>(pipe_and(
      R"({"name": "c", "spline": {"from": "a.end", "to": "b.start", "through": [{"point": [12, 1, 0], "radius": 1.5}]}})"));
  EXPECT_EQ(open.from, (PortReference{"a", End::end}));
  EXPECT_EQ(open.to, (PortReference{"b", End::start}));
  ASSERT_EQ(open.through.size(), 1U);
  EXPECT_EQ(open.through[0].point, Vec3(12, 1, 0));
  EXPECT_EQ(open.through[0].radius, 1.5);
  EXPECT_TRUE(read_last<SplineRound>(
                  document(R"({"name": "c", "spline": {"through": [], "closed": true}})"))
                  .through.empty());
}

TEST(SplineKey, reads_what_it_avoids) {
  const auto spline = read_last<SplineBetween>(pipe_and(
      R"({"name": "c", "spline": {"from": "a.end", "to": "b.start", "clearance": 2, "avoid": [
          {"ball": {"center": [1, 2, 3], "radius": 4}},
          {"capsule": {"from": [1, 2, 3], "to": [1, 2, 8], "radius": 4}},
          {"box": {"corner": [1, 1, 1], "neighbours": [{"point": [2, 1, 1]}, {"point": [1, 3, 1]}, {"point": [1, 1, 4]}]}},
          {"part": "a"}]}})"));
  EXPECT_TRUE(spline.through.empty());
  ASSERT_TRUE(spline.avoid);
  EXPECT_EQ(spline.avoid->clearance, 2);
  ASSERT_EQ(spline.avoid->obstacles.size(), 4);
  const auto& ball = std::get<Obstacle>(spline.avoid->obstacles[0]);
  const auto& capsule = std::get<Obstacle>(spline.avoid->obstacles[1]);
  const auto& box = std::get<Obstacle>(spline.avoid->obstacles[2]);
  EXPECT_EQ(ball.corner, Vec3(1, 2, 3));
  EXPECT_TRUE(ball.edges.empty());
  EXPECT_EQ(capsule.edges, (std::vector<Vec3>{{0, 0, 5}}));
  EXPECT_EQ(capsule.radius, 4);
  EXPECT_EQ(box.edges, (std::vector<Vec3>{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}));
  EXPECT_EQ(box.radius, 0);
  EXPECT_EQ(std::get<std::string>(spline.avoid->obstacles[3]), "a");
}

TEST(SplineKey, says_what_is_wrong_with_what_it_avoids) {
  constexpr Errc kBad = Errc::invalid_argument;
  const auto avoiding = [](const std::string& avoid, const std::string& clearance = "1") {
    return pipe_and(R"({"name": "b", "pipe": {"from": [20, 0, 0], "to": [29, 0, 0], "radius": 1}},
        {"name": "c", "spline": {"from": "a.end", "to": "b.start", "clearance": )" +
                    clearance + R"(, "avoid": )" + avoid + "}}");
  };
  const std::string at = "d.json#/parts/2/spline";
  const Malformed rows[] = {
      {avoiding("[{}]"), at + "/avoid/0", "must have one of ball, capsule, box, part and mesh"},
      {avoiding(R"([{"part": "x", "ball": {}}])"), at + "/avoid/0",
       "must have one of ball, capsule, box, part and mesh"},
      {avoiding(R"([{"box": {"corner": [0, 0, 0], "neighbours": []}}])"),
       at + "/avoid/0/box/neighbours", "a box has three corners next to its first one"},
      {avoiding(R"([{"ball": {"center": [5, 5, 5], "radius": -1}}])"), at + "/avoid/0",
       "'c': must be a positive number between 1e-12 and 1e12, not -1", kBad},
      {avoiding("[]", "-1"), at + "/clearance",
       "'c': the clearance must be 0 or a number between 1e-12 and 1e12, not -1", kBad},
      {avoiding(R"([{"part": "nobody"}])"), at + "/avoid", "'c': there is no part named 'nobody'",
       kBad},
      {avoiding(R"([{"part": "a"}])"), at + "/avoid", "'c': 'a' is where it begins or ends", kBad},
      {avoiding(R"([{"part": "c"}])"), at + "/avoid",
       "'c': parts must not begin at each other in a circle: 'c' -> 'c'", kBad},
      {pipe_and(R"({"name": "c", "spline": {"from": "a.end", "to": "b.start", "through": [],
          "clearance": 1}})"),
       "d.json#/parts/1/spline/clearance", "is from what 'avoid' lists, which is missing"},
      {document(R"({"name": "a", "spline": {"through": [], "closed": true, "avoid": []}})"),
       "d.json#/parts/0/spline/avoid",
       "is for pipes between two ports; a closed pipe goes through its points"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

TEST(SplineKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(R"({"name": "a", "spline": {"through": [], "closed": false}})"),
       "d.json#/parts/0/spline/closed", "must be true, or left out for a pipe between two ports"},
      {document(R"({"name": "a", "spline": {"from": "b.end", "through": [], "closed": true}})"),
       "d.json#/parts/0/spline",
       "a closed pipe has no ports to begin or end at; leave out 'from' and 'to'"},
      {document(
           R"({"name": "r", "spline": {"through": [{"point": [0, 0, 0], "radius": 1}, {"point": [9, 0, 0], "radius": 0}], "closed": true}})"),
       "d.json#/parts/0/spline/through/1/radius",
       "'r': must be a positive number between 1e-12 and 1e12, not 0", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
