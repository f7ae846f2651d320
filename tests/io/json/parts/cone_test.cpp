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

TEST(ConeKey, reads_and_resolves_its_forms) {
  const auto between = read_last<ConeBetween>(
      document(R"({"name": "c", "cone": {"from": [0, 0, 0], "to": [4, 0, 0], "radii": [1, 2]}})"));
  EXPECT_EQ(between.start_radius, 1);
  EXPECT_EQ(between.end_radius, 2);
  const std::string text = pipe_and(
      R"({"name": "c", "cone": {"from": "a.end", "length": 4, "end_semi_axes": [2, 3], "axis": [0, 0, 1]}})");
  const auto along = read_last<ConeAlong>(text);
  EXPECT_EQ(along.end_radius, 2);
  EXPECT_EQ(along.end_across, 3);
  EXPECT_EQ(along.axis, Vec3(0, 0, 1));
  const auto resolved = resolve(parse_assembly(text));
  const Ring& end = *port_ring(resolved.parts[1].shape, PartEnd::end);
  EXPECT_EQ(end.center, Vec3(13, 0, 0));
  EXPECT_EQ(end.ellipse.value().across, 3);
}

TEST(ConeKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(
           R"({"name": "a", "cone": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [[1, 2], [1, 2], [1, 2]], "axis": [0, 0, 1]}})"),
       "d.json#/parts/0/cone/semi_axes", "must be the semi-axes at both ends [start, end]"},
      {document(R"({"name": "a", "cone": {"from": [0, 0, 0], "to": [1, 0, 0], "radii": [1]}})"),
       "d.json#/parts/0/cone/radii", "must be two numbers [start, end]"},
      {document(R"({"name": "a", "cone": {"from": "b.end", "length": 1, "radii": [1, 2]}})"),
       "d.json#/parts/0/cone",
       "from a port, give {from, length, end_radius} or {from, length, end_semi_axes} or {from, "
       "length, "
       "end_semi_axes, axis}"},
      {document(R"({"name": "p", "cone": {"from": [1, 1, 0], "to": [1, 0, 0], "radii": [1, 0]}})"),
       "d.json#/parts/0/cone/radii/1",
       "'p': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {pipe_and(R"({"name": "c", "cone": {"from": "a.end", "length": 3, "end_radius": -2}})"),
       "d.json#/parts/1/cone/end_radius",
       "'c': must be a positive number between 1e-12 and 1e12, not -2", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
