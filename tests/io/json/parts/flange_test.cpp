#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::pipe_and;
using test::read_last;

const Ring& ring(const ResolvedAssembly& assembly, End end) {
  return *port_ring(assembly.parts.back().shape, end);
}

TEST(FlangeKey, lies_about_an_end_level_with_it) {
  const std::string text =
      pipe_and(R"({"name": "f", "flange": {"at": "a.end", "radius": 3, "thickness": 0.5}})");
  const auto shape = read_last<FlangeOfEnd>(text);
  EXPECT_EQ(shape.at, (PortReference{"a", End::end}));
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(ring(resolved, End::start).center, Vec3(8.5, 0, 0));
  EXPECT_EQ(ring(resolved, End::end).center, Vec3(9, 0, 0));
  EXPECT_EQ(ring(resolved, End::end).radius, 3);
  EXPECT_FALSE(resolved.parts[0].joined[1]) << "the pipe's end stays free";
  EXPECT_EQ(ports(resolved).size(), 2) << "a flange's faces are no ports";
}

TEST(FlangeKey, that_is_solid_closes_the_end_from_outside) {
  const auto resolved = resolve(parse_assembly(pipe_and(
      R"({"name": "f", "solid": true, "flange": {"at": "a.start", "radius": 3, "thickness": 1}})")));
  EXPECT_EQ(ring(resolved, End::start).center, Vec3(0, 0, 0));
  EXPECT_EQ(ring(resolved, End::end).center, Vec3(-1, 0, 0));
}

TEST(FlangeKey, lies_on_a_pipe_or_by_itself) {
  const auto on = resolve(parse_assembly(
      pipe_and(R"({"name": "f", "flange": {"on": "a", "at": 4, "radius": 3, "thickness": 1}})")));
  EXPECT_EQ(ring(on, End::start).center, Vec3(3.5, 0, 0));
  const auto free = resolve(parse_assembly(pipe_and(
      R"({"name": "f", "flange": {"center": [1, 2, 3], "normal": [0, 0, 5], "radius": 3, "thickness": 2}})")));
  EXPECT_EQ(ring(free, End::start).center, Vec3(1, 2, 2));
  EXPECT_EQ(ring(free, End::end).center, Vec3(1, 2, 4));
}

TEST(FlangeKey, has_the_dimensions_of_its_size_and_class) {
  const auto shape = read_last<FlangeOfEnd>(
      pipe_and(R"({"name": "f", "flange": {"at": "a.end", "size": "DN100", "class": 150}})"));
  EXPECT_EQ(shape.radius, 115);
  EXPECT_EQ(shape.thickness, 22.3);
}

TEST(FlangeKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {pipe_and(R"({"name": "f", "flange": {"at": "a.end", "radius": 3}})"),
       "d.json#/parts/1/flange", "the key 'thickness' is missing"},
      {pipe_and(R"({"name": "f", "flange": {"at": "a.end", "length": 3}})"),
       "d.json#/parts/1/flange/length",
       "unknown key; known here are at, radius, thickness, size, class"},
      {pipe_and(R"({"name": "f", "flange": {"at": "a.end", "size": "DN100", "class": 600}})"),
       "d.json#/parts/1/flange/class",
       "there is no flange of NPS 4 in class 600 here, but of NPS 1/2 to 24 in classes 150 and 300 "
       "of ASME B16.5"},
      {pipe_and(R"({"name": "f", "flange": {"at": "a.end", "radius": -3, "thickness": 1}})"),
       "d.json#/parts/1/flange/radius",
       "'f': must be a positive number between 1e-12 and 1e12, not -3", kBad},
      {pipe_and(R"({"name": "f", "flange": {"at": "b.end", "radius": 3, "thickness": 1}})"),
       "d.json#/parts/1/flange/at", "'f': there is no part named 'b'", kBad},
      {pipe_and(R"({"name": "f", "flange": {"on": "a", "at": 10, "radius": 3, "thickness": 1}})"),
       "d.json#/parts/1/flange/at",
       "'f': must be from 0 to the length of the part it is on, 9, not 10", kBad},
      {pipe_and(
           R"({"name": "f", "wall": 1, "flange": {"at": "a.end", "radius": 3, "thickness": 1}})"),
       "d.json#/parts/1/wall",
       "'f': a flange has no bore of its own, but those of others pass through it", kBad},
      {pipe_and(R"({"name": "f", "flange": {"at": "a.end", "radius": 3, "thickness": 1}},
                   {"name": "g", "pipe": {"from": "f.end", "length": 1}})"),
       "d.json#/parts/2/pipe/from", "'g': 'f' is a flange and has no ports", kBad},
      {pipe_and(
           R"({"name": "f", "flange": {"center": [0, 0, 0], "normal": [0, 0, 0], "radius": 3, "thickness": 1}})"),
       "d.json#/parts/1/flange/normal", "'f': the direction must not be zero", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
