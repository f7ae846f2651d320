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

TEST(RingedBlendKey, reads_its_ends) {
  const auto blend = read_last<RingedBlendBetween>(pipe_and(
      R"({"name": "c", "ringed_blend": {"from": "a.end", "to": {"center": [12, 3, 0], "direction": [0, 1, 0], "radius": 2, "plate": "widening"}, "k": "auto", "l": 4, "bidegree": [5, 2]}})"));
  EXPECT_EQ(std::get<PortReference>(blend.from), (PortReference{"a", PartEnd::end}));
  const auto& end = std::get<FreeEnd>(blend.to);
  EXPECT_EQ(end.center, Vec3(12, 3, 0));
  EXPECT_EQ(end.radius, 2);
  EXPECT_TRUE(std::get<PlateContact>(end.contact).widening);
  EXPECT_FALSE(blend.k);
  EXPECT_EQ(blend.l, 4);
  EXPECT_TRUE(blend.low_degree);
}

TEST(RingedBlendKey, says_what_is_wrong_with_it) {
  const Malformed rows[] = {
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "apex": [0, 0, 1], "slope": 0}}})"),
       "d.json#/parts/0/ringed_blend/to", "give at most one of slope, sphere, apex, ruling, plate"},
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "plate": 1}}})"),
       "d.json#/parts/0/ringed_blend/to/plate", "must be a string, not number"},
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": "c.start", "bidegree": [3, 2]}})"),
       "d.json#/parts/0/ringed_blend/bidegree", "must be [9, 2] or [5, 2]"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
