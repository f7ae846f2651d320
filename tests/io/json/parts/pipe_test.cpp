#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::kPipe;
using test::Malformed;
using test::pipe_and;
using test::read_last;

TEST(PipeKey, reads_and_resolves_its_forms) {
  const auto between = read_last<PipeBetween>(document(kPipe));
  EXPECT_EQ(between.to, Vec3(9, 0, 0));
  EXPECT_EQ(between.radius, 1);
  const auto oval = read_last<PipeBetween>(document(
      R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "semi_axes": [2, 1], "axis": [0, 0, 1]}})"));
  EXPECT_EQ(oval.radius, 2);
  EXPECT_EQ(oval.axes.value().across, 1);
  const auto along =
      read_last<PipeAlong>(pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "length": 3}})"));
  EXPECT_EQ(std::get<PortReference>(along.from).part, "a");
  EXPECT_EQ(along.length, 3);
  const std::string text =
      pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [12, 0, 0]}})");
  EXPECT_EQ(read_last<PipeTo>(text).to, Vec3(12, 0, 0));
  EXPECT_EQ(port_ring(resolve(parse_assembly(text)).parts[1].shape, End::end)->center,
            Vec3(12, 0, 0));
}

TEST(PipeKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(
           R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1], "axis": [0, 0, 1]}})"),
       "d.json#/parts/0/pipe/semi_axes", "must be two numbers [along the axis, across it]"},
      {document(
           R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1, 2]}})"),
       "d.json#/parts/0/pipe",
       "from a point, give {from, to, semi_axes, axis} or {from, direction, length, semi_axes, "
       "axis}"},
      {document(R"({"name": "a", "pipe": []})"), "d.json#/parts/0/pipe",
       "must be an object, not array"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, 0], "too": [1, 0, 0]}})"),
       "d.json#/parts/0/pipe/too",
       "unknown key; known here are from, to, radius, size, schedule, outside_diameter, "
       "inside_diameter, direction, length, semi_axes, axis, on, at"},
      {document(R"({"name": "a", "pipe": {"to": [1, 0, 0], "radius": 1}})"), "d.json#/parts/0/pipe",
       "the key 'from' is missing"},
      {document(R"({"name": "a", "pipe": {"from": 0, "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from", "must be a point [x, y, z] or a port 'part.end', not number"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0]}})"),
       "d.json#/parts/0/pipe",
       "from a point, give {from, to, radius} or {from, direction, length, radius}"},
      {document(R"({"name": "a", "pipe": {"from": "b.end", "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe", "from a port, give {from, length} or {from, to}"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from", "must be three numbers [x, y, z], not 2"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, null], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from/2", "must be a number, not null"},
      {document(R"({"name": "p", "pipe": {"from": [1, 1, 0], "to": [1, 1, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/to",
       "'p': the point must be 1e-12 or more away from the one at 'from'", kBad},
      {document(
           R"({"name": "p", "pipe": {"from": [1, 1, 0], "direction": [0, 0, 0], "length": 1, "radius": 1}})"),
       "d.json#/parts/0/pipe/direction", "'p': the direction must not be zero", kBad},
      {document(
           R"({"name": "p", "pipe": {"from": [1, 1, 0], "direction": [1, 0, 0], "length": 0, "radius": 1}})"),
       "d.json#/parts/0/pipe/length",
       "'p': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [8, 0, 0]}})"),
       "d.json#/parts/1/pipe/to", "'c': the point must lie ahead of 'a.end', not 1 behind it",
       kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [9, 0.25, 0]}})"),
       "d.json#/parts/1/pipe/to", "'c': the point must lie ahead of 'a.end', not level with it",
       kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [10, 0.25, 0]}})"),
       "d.json#/parts/1/pipe/to",
       "'c': the point is 0.25 off the pipe's axis, more than the tolerance of 0.05 allows", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
