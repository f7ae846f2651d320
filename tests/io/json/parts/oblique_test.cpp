#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::read_last;

TEST(ObliqueKey, reads_its_centres_its_normal_and_its_radii) {
  const std::string text = document(
      R"({"name": "o", "oblique": {"from": [0, 0, 0], "to": [1, 0, 4], "normal": [0, 0, 1], "radii": [1, 2]}})");
  const auto part = read_last<ObliqueBetween>(text);
  EXPECT_EQ(part.to, Vec3(1, 0, 4));
  EXPECT_EQ(part.normal, Vec3(0, 0, 1));
  EXPECT_EQ(part.start_radius, 1);
  const auto resolved = resolve(parse_assembly(text));
  const Ring& end = *port_ring(resolved.parts[0].shape, End::end);
  EXPECT_EQ(end.center, Vec3(1, 0, 4));
  EXPECT_EQ(end.radius, 2);
}

TEST(ObliqueKey, goes_on_from_a_port_with_circles_parallel_to_it) {
  const std::string text = document(
      R"({"name": "a", "pipe": {"from": [0, 0, -3], "to": [0, 0, 0], "radius": 2}},
         {"name": "o", "oblique": {"from": "a.end", "to": [1, 0, 4], "end_radius": 1}},
         {"name": "b", "pipe": {"from": "o.end", "length": 2}})");
  EXPECT_EQ(read_last<PipeAlong>(text).length, 2);
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(*port_ring(resolved.parts[1].shape, End::start),
            flipped(*port_ring(resolved.parts[0].shape, End::end)));
  const Ring& end = *port_ring(resolved.parts[1].shape, End::end);
  EXPECT_EQ(end.center, Vec3(1, 0, 4));
  EXPECT_EQ(end.normal, Vec3(0, 0, 1));
  EXPECT_EQ(end.radius, 1);
}

TEST(ObliqueKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(
           R"({"name": "o", "oblique": {"from": [0, 0, 0], "to": [1, 0, 4], "radii": [1, 2]}})"),
       "d.json#/parts/0/oblique", "from a point, give {from, to, normal, radii}"},
      {document(
           R"({"name": "o", "oblique": {"from": [0, 0, 0], "to": [1, 0, 4], "normal": [0, 0, 1], "radii": [1, -2]}})"),
       "d.json#/parts/0/oblique/radii/1",
       "'o': must be a positive number between 1e-12 and 1e12, not -2", kBad},
      {document(
           R"({"name": "a", "pipe": {"from": [0, 0, -3], "to": [0, 0, 0], "radius": 2}},
              {"name": "o", "oblique": {"from": "a.end", "to": [1, 0, -4], "end_radius": 1}})"),
       "d.json#/parts/1",
       "'o': the normal must be less than 90 degrees off the direction of travel", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
