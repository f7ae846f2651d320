#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::pipe_and;
using test::read_last;

TEST(CyclicBlendKey, reads_its_options) {
  const auto blend = read_last<CyclicBlendBetween>(pipe_and(
      R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "radius_law": "R2", "k": 8, "l": "auto", "continuity": "G2"}})"));
  EXPECT_EQ(blend.from, (PortReference{"a", End::end}));
  EXPECT_EQ(blend.to, (PortReference{"b", End::start}));
  EXPECT_EQ(blend.options.radius_law, BlendLaw::r2);
  EXPECT_EQ(blend.options.continuity, Continuity::g2);
  EXPECT_EQ(blend.options.k, 8);
  EXPECT_FALSE(blend.options.l);
}

TEST(CyclicBlendKey, takes_the_radius_law_r1_if_none_is_given) {
  const auto blend = read_last<CyclicBlendBetween>(pipe_and(
      R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "k": 8, "l": "auto", "continuity": "G2"}})"));
  EXPECT_EQ(blend.options.radius_law, BlendLaw::r1);
  EXPECT_EQ(blend.options.continuity, Continuity::g2);
}

TEST(CyclicBlendKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {pipe_and(
           R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "radius_law": "R3", "k": 1, "l": 1}})"),
       "d.json#/parts/1/cyclic_blend/radius_law", "must be \"R1\" or \"R2\", not \"R3\""},
      {pipe_and(
           R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "radius_law": "R1", "k": 1, "l": 1, "continuity": "C2"}})"),
       "d.json#/parts/1/cyclic_blend/continuity", "must be \"G1\" or \"G2\", not \"C2\""},
      {pipe_and(
           R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "radius_law": "R1", "k": 1, "l": "best"}})"),
       "d.json#/parts/1/cyclic_blend/l", "must be a number or \"auto\""},
      {pipe_and(
           R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "radius_law": "R1", "k": 1}})"),
       "d.json#/parts/1/cyclic_blend", "the key 'l' is missing"},
      {pipe_and(R"({"name": "c", "cone": {"from": "a.end", "length": 2, "end_radius": 2}},
                   {"name": "b", "pipe": {"from": [15, 3, 0], "to": [20, 3, 0], "radius": 2}},
                   {"name": "d", "cyclic_blend": {"from": "c.end", "to": "b.start", "radius_law": "R2", "k": 5, "l": 5}})"),
       "d.json#/parts/3",
       "'d': the radius law R2 goes with tangent continuity between cylinders only; take R1", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
