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

TEST(CapKey, names_the_end_that_it_refers_to) {
  const std::string text = pipe_and(R"({"name": "lid", "cap": {"at": "a.end"}})");
  EXPECT_EQ(read_last<CapAt>(text).at, (PortReference{"a", End::end}));
  const auto resolved = resolve(parse_assembly(text));
  ASSERT_EQ(resolved.parts.size(), 1U);
  EXPECT_EQ(resolved.parts[0].end_names[1], "lid");
}

TEST(CapKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {pipe_and(R"({"name": "c", "cap": {"at": 1}})"), "d.json#/parts/1/cap/at",
       "must be a string, not number"},
      {document(
           R"({"name": "s", "sphere": {"center": [0, 0, 0], "radius": 1}}, {"name": "c", "cap": {"at": "s.end"}})"),
       "d.json#/parts/1/cap/at", "'c': 's' is a sphere and has no ports", kBad},
      {document(
           R"({"name": "r", "spline": {"through": [], "closed": true}}, {"name": "c", "cap": {"at": "r.end"}})"),
       "d.json#/parts/1/cap/at", "'c': 'r' is a closed spline and has no ports", kBad},
      {pipe_and(
           R"({"name": "lid", "cap": {"at": "a.end"}}, {"name": "c", "cap": {"at": "lid.end"}})"),
       "d.json#/parts/2/cap/at", "'c': 'lid' is a cap and has no ports", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
