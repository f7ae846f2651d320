#include <numbers>
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

TEST(ElbowKey, reads_its_forms) {
  const auto turning = read_last<ElbowTurning>(pipe_and(
      R"({"name": "c", "elbow": {"from": "a.end", "bend_radius": 3, "angle": 90, "toward": [0, 1, 0]}})"));
  EXPECT_EQ(turning.bend_radius, 3);
  EXPECT_EQ(turning.angle, std::numbers::pi / 2);
  EXPECT_EQ(
      read_last<ElbowTo>(pipe_and(R"({"name": "c", "elbow": {"from": "a.end", "to": [12, 3, 0]}})"))
          .to,
      Vec3(12, 3, 0));
  const auto corner = read_last<ElbowCorner>(document(
      R"({"name": "e", "elbow": {"from": [0, 0, 0], "corner": [2, 0, 0], "to": [2, 2, 0], "radius": 1}})"));
  EXPECT_EQ(corner.corner, Vec3(2, 0, 0));
  EXPECT_EQ(std::get<Place>(corner.from).direction, Vec3(2, 0, 0));
}

TEST(ElbowKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const std::string from_a = R"({"name": "c", "elbow": {"from": "a.end", )";
  const Malformed rows[] = {
      {document(R"({"name": "a", "elbow": {"from": [0, 0, 0], "to": [1, 0, 0]}})"),
       "d.json#/parts/0/elbow",
       "from a point, give {from, direction, radius, bend_radius, angle, toward} or {from, "
       "direction, to, radius} or {from, corner, to, radius}"},
      {document(
           R"({"name": "a", "elbow": {"from": [0, 0, 0], "corner": [0, 0, 0], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/elbow/corner", "the corner must differ from the point at 'from'"},
      {pipe_and(from_a + R"("bend_radius": 2, "angle": 360, "toward": [0, 1, 0]}})"),
       "d.json#/parts/1/elbow/angle",
       "'c': an elbow's angle must lie between 0 and 360 degrees, not at 360", kBad},
      {pipe_and(from_a + R"("bend_radius": 2, "angle": 90, "toward": [2, 0, 0]}})"),
       "d.json#/parts/1/elbow/toward",
       "'c': the direction must have a part across the direction of travel", kBad},
      {pipe_and(from_a + R"("to": [12, 0, 0]}})"), "d.json#/parts/1/elbow/to",
       "'c': the point lies on the axis; a pipe leads there", kBad},
      {pipe_and(from_a + R"("corner": [11, 1, 0], "to": [11, 3, 0]}})"),
       "d.json#/parts/1/elbow/corner",
       "'c': the corner is 1 off the axis, more than the tolerance of 0.05 allows", kBad},
      {pipe_and(from_a + R"("corner": [11, 0, 0], "to": [13, 0, 0]}})"), "d.json#/parts/1/elbow/to",
       "'c': the corner is none: both legs lie on one line", kBad},
      {document(
           R"({"name": "e", "elbow": {"from": [0, 0, 0], "corner": [2, 0, 0], "to": [2, 3, 0], "radius": 1}})"),
       "d.json#/parts/0/elbow/corner",
       "'e': the legs from the corner are 2 and 3 long, more than the tolerance of 0.05 allows",
       kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
