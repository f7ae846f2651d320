#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::read_last;
using test::tee_and;

TEST(CopeKey, reads_its_end_and_what_it_is_cut_to) {
  const std::string text =
      tee_and(R"({"name": "c", "cope": {"end": "branch.start", "to": "run"}})");
  const auto shape = read_last<CopeOfEnd>(text);
  EXPECT_EQ(shape.end, (PortReference{"branch", End::start}));
  EXPECT_EQ(shape.to, "run");
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(resolved.parts.size(), 2U);
  ASSERT_EQ(resolved.fillets.size(), 1U);
  EXPECT_TRUE(resolved.fillets[0].shape.is_cope());
  EXPECT_EQ(ports(resolved).size(), 3U) << "the end is cut off";
}

TEST(CopeKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {tee_and(R"({"name": "c", "cope": {"end": "branch", "to": "run"}})"),
       "d.json#/parts/2/cope/end", "must name a port as 'part.start' or 'part.end', not 'branch'"},
      {tee_and(R"({"name": "c", "cope": {"end": "branch.start"}})"), "d.json#/parts/2/cope",
       "the key 'to' is missing"},
      {tee_and(R"({"name": "c", "cope": {"end": "branch.start", "to": "run", "radius": 0}})"),
       "d.json#/parts/2/cope/radius", "unknown key; known here are end, to"},
      {tee_and(R"({"name": "c", "cope": {"end": "branch.start", "to": "rum"}})"),
       "d.json#/parts/2/cope/to", "'c': there is no part named 'rum'", kBad},
      {tee_and(R"({"name": "c", "cope": {"end": "branch.end", "to": "run"}})"),
       "d.json#/parts/2/cope/end",
       "'c': 'branch.end' does not lie inside 'run', where it would be cut off", kBad},
      {tee_and(R"({"name": "c", "cope": {"end": "branch.start", "to": "run"}},
                  {"name": "g", "pipe": {"from": "c.end", "length": 1}})"),
       "d.json#/parts/3/pipe/from", "'g': 'c' is a cope and has no ports", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
