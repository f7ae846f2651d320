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
  EXPECT_EQ(open.from, (PortReference{"a", PartEnd::end}));
  EXPECT_EQ(open.to, (PortReference{"b", PartEnd::start}));
  ASSERT_EQ(open.through.size(), 1U);
  EXPECT_EQ(open.through[0].point, Vec3(12, 1, 0));
  EXPECT_EQ(open.through[0].radius, 1.5);
  EXPECT_TRUE(read_last<SplineRound>(
                  document(R"({"name": "c", "spline": {"through": [], "closed": true}})"))
                  .through.empty());
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
