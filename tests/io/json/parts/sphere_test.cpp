#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::read_last;

TEST(SphereKey, reads_its_centre_and_its_radius) {
  const std::string text =
      document(R"({"name": "s", "sphere": {"center": [1, 2, 3], "radius": 4}})");
  EXPECT_EQ(read_last<SphereAt>(text).center, Vec3(1, 2, 3));
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(resolved.parts[0].kind, "sphere");
  EXPECT_EQ(port_ring(resolved.parts[0].shape, PartEnd::start), nullptr);
}

TEST(SphereKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {document(R"({"name": "a", "sphere": {"center": [0, 0, 0], "r": 1}})"),
       "d.json#/parts/0/sphere/r", "unknown key; known here are center, radius"},
      {document(R"({"name": "s", "sphere": {"center": [0, 0, 0], "radius": -1}})"),
       "d.json#/parts/0/sphere/radius",
       "'s': must be a positive number between 1e-12 and 1e12, not -1", kBad},
      {document(R"({"name": "s", "sphere": {"center": [0, 1e15, 0], "radius": 1}})"),
       "d.json#/parts/0/sphere/center", "'s': coordinates must be finite numbers of at most 1e12",
       kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
