#include <array>
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

TEST(TwoConeBlendKey, reads_its_reach_and_its_weights) {
  const auto blend = read_last<TwoConeBlendBetween>(pipe_and(
      R"({"name": "c", "two_cone_blend": {"from": "a.end", "to": "b.start", "reach": [2, 3], "w": [1, 2, 1]}})"));
  EXPECT_EQ(blend.to, (PortReference{"b", PartEnd::start}));
  EXPECT_EQ(blend.reach, (std::array<double, 2>{2, 3}));
  EXPECT_EQ(blend.m, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(blend.w, (std::array<double, 3>{1, 2, 1}));
}

TEST(TwoConeBlendKey, says_what_is_wrong_with_it) {
  const Malformed rows[] = {
      {document(
           R"({"name": "a", "two_cone_blend": {"from": "b.end", "to": "c.start", "reach": 1}})"),
       "d.json#/parts/0/two_cone_blend/reach", "must be an array, not number"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
