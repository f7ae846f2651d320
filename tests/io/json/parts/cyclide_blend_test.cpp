#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::pipe_and;
using test::read_last;

TEST(CyclideBlendKey, reads_its_ends) {
  const auto blend = read_last<CyclideBlendBetween>(
      pipe_and(R"({"name": "c", "cyclide_blend": {"from": "a.end", "to": "b.start"}})"));
  EXPECT_EQ(blend.from, (PortReference{"a", PartEnd::end}));
  EXPECT_EQ(blend.to, (PortReference{"b", PartEnd::start}));
}

TEST(CyclideBlendKey, says_what_is_wrong_with_it) {
  const Malformed rows[] = {
      {pipe_and(R"({"name": "c", "cyclide_blend": {"from": "a.end"}})"),
       "d.json#/parts/1/cyclide_blend", "the key 'to' is missing"},
      {pipe_and(R"({"name": "c", "cyclide_blend": {"from": "a.end", "to": "b.start", "k": 1}})"),
       "d.json#/parts/1/cyclide_blend/k", "unknown key; known here are from, to"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
