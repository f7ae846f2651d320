#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::read_last;
using test::tee_and;

TEST(FilletKey, reads_its_pipes_and_its_radius) {
  const std::string text =
      tee_and(R"({"name": "f", "fillet": {"between": ["run", "branch"], "radius": 0.5}})");
  const auto shape = read_last<FilletBetween>(text);
  EXPECT_EQ(shape.between[0], "run");
  EXPECT_EQ(shape.between[1], "branch");
  EXPECT_EQ(shape.radius, 0.5);
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(resolved.parts.size(), 2U) << "a fillet is no part with ends";
  ASSERT_EQ(resolved.fillets.size(), 1U);
  EXPECT_EQ(resolved.fillets[0].between[1], 1U);
  EXPECT_EQ(resolved.fillets[0].shape.loops.size(), 1U);
  EXPECT_EQ(ports(resolved).size(), 3U) << "the branch starts inside the run";
}

TEST(FilletKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {tee_and(R"({"name": "f", "fillet": {"between": ["run"], "radius": 1}})"),
       "d.json#/parts/2/fillet/between", "must be the names of two parts"},
      {tee_and(R"({"name": "f", "fillet": {"between": "run", "radius": 1}})"),
       "d.json#/parts/2/fillet/between", "must be an array, not string"},
      {tee_and(R"({"name": "f", "fillet": {"between": ["run", 1], "radius": 1}})"),
       "d.json#/parts/2/fillet/between/1", "must be a string, not number"},
      {tee_and(R"({"name": "f", "fillet": {"between": ["run", "branch"], "size": 1}})"),
       "d.json#/parts/2/fillet/size", "unknown key; known here are between, radius"},
      {tee_and(R"({"name": "f", "fillet": {"between": ["run", "brunch"], "radius": 1}})"),
       "d.json#/parts/2/fillet/between", "'f': there is no part named 'brunch'", kBad},
      {tee_and(R"({"name": "f", "fillet": {"between": ["run", "branch"], "radius": 0}})"),
       "d.json#/parts/2/fillet/radius",
       "'f': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {tee_and(R"({"name": "f", "fillet": {"between": ["run", "branch"], "radius": 0.2}},
                  {"name": "g", "pipe": {"from": "f.end", "length": 1}})"),
       "d.json#/parts/3/pipe/from", "'g': 'f' is a fillet and has no ports", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
