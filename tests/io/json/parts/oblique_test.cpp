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
  const Ring& end = *port_ring(resolved.parts[0].shape, PartEnd::end);
  EXPECT_EQ(end.center, Vec3(1, 0, 4));
  EXPECT_EQ(end.radius, 2);
}

TEST(ObliqueKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(
           R"({"name": "o", "oblique": {"from": [0, 0, 0], "to": [1, 0, 4], "radii": [1, 2]}})"),
       "d.json#/parts/0/oblique", "the key 'normal' is missing"},
      {document(
           R"({"name": "o", "oblique": {"from": [0, 0, 0], "to": [1, 0, 4], "normal": [0, 0, 1], "radii": [1, -2]}})"),
       "d.json#/parts/0/oblique/radii/1",
       "'o': must be a positive number between 1e-12 and 1e12, not -2", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
