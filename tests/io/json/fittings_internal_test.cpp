#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "io/json/document_fault.h"
#include "json/fittings.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::pipe_and;

const std::string kTee =
    R"({"name": "t", "wall": 0.2, "tee": {"from": "a.end", "length": 8,
        "branch": {"direction": [0, 0, 1], "length": 4, "radius": 0.6}, "fillet": 0.2}})";
const std::string kValve =
    R"({"name": "v", "valve": {"from": [0, 0, 0], "direction": [1, 0, 0], "radius": 1, "length": 6,
        "body": {"radius": 2, "length": 3}, "stem": {"direction": [0, 0, 1], "length": 4, "radius": 0.3}}})";

TEST(Fittings, tee_is_a_run_a_branch_and_a_fillet) {
  const Assembly assembly = parse_assembly(pipe_and(kTee));
  ASSERT_EQ(assembly.parts.size(), 4);
  EXPECT_EQ(assembly.parts[1].name, "t");
  EXPECT_EQ(assembly.parts[2].name, "t-branch");
  EXPECT_EQ(assembly.parts[3].name, "t-fillet");
  const auto& branch = std::get<PipeOn>(assembly.parts[2].shape);
  EXPECT_EQ(branch.run, "t");
  EXPECT_EQ(branch.at, 4) << "from the middle, if not said";
  EXPECT_EQ(std::get<FilletBetween>(assembly.parts[3].shape).radius, 0.2);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(assembly.parts[i].component.name, "t");
    EXPECT_EQ(assembly.parts[i].component.kind, "tee");
    EXPECT_EQ(assembly.parts[i].wall, i < 3 ? std::optional(0.2) : std::nullopt);
  }
  EXPECT_EQ(build(assembly).solid.components(), 1);
}

TEST(Fittings, valve_is_a_pipe_with_a_body_and_a_stem_without_bores) {
  Assembly assembly = parse_assembly(document(kValve));
  ASSERT_EQ(assembly.parts.size(), 3);
  assembly.wall = 0.2;
  assembly.tolerance = 0.001;
  const Built fluid = build(assembly, {.region = Region::fluid});
  // A pipe's bore goes through all of it.
  EXPECT_NEAR(fluid.solid.volume(), 3.14159 * 0.64 * 6, 0.03);
  EXPECT_EQ(fluid.solid.euler_number(), 2);
  EXPECT_EQ(build(assembly, {.region = Region::metal}).solid.euler_number(), 0);
}

TEST(Fittings, are_parts_of_a_document_in_full) {
  const Assembly assembly = parse_assembly(pipe_and(kTee));
  const Assembly again = parse_assembly(document_text(assembly));
  EXPECT_EQ(document_text(again), document_text(assembly));
  EXPECT_EQ(again.parts[2].component.kind, "tee");
}

TEST(Fittings, branch_has_a_size_and_a_wall_of_its_own) {
  const Assembly assembly = parse_assembly(document(
      R"({"name": "t", "wall": 3, "tee": {"from": [0, 0, 0], "direction": [1, 0, 0], "size": "DN100", "length": 200,
          "branch": {"at": 80, "direction": [0, 0, 1], "length": 90, "size": "DN50", "schedule": 40}}})"));
  ASSERT_EQ(assembly.parts.size(), 2);
  EXPECT_EQ(std::get<PipeOn>(assembly.parts[1].shape).radius, 60.3 / 2);
  EXPECT_EQ(std::get<PipeOn>(assembly.parts[1].shape).at, 80);
  EXPECT_EQ(assembly.parts[1].wall, 3.91);
  EXPECT_EQ(assembly.parts[0].wall, 3);
}

TEST(Fittings, say_what_is_wrong_by_their_own_keys) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {pipe_and(R"({"name": "t", "tee": {"from": "a.end", "length": 8}})"), "d.json#/parts/1/tee",
       "the key 'branch' is missing"},
      {pipe_and(
           R"({"name": "t", "tee": {"from": "a.end", "radius": 1, "length": 8, "branch": {}}})"),
       "d.json#/parts/1/tee/radius", "unknown key; known here are from, length, branch, fillet"},
      {pipe_and(
           R"({"name": "t", "tee": {"from": "a.end", "length": "8", "branch": {"direction": [0, 0, 1], "length": 1, "radius": 1}}})"),
       "d.json#/parts/1/tee/length", "must be a number, not string"},
      {pipe_and(
           R"({"name": "t", "tee": {"from": "a.end", "length": 8, "branch": {"direction": [0, 0, 1], "length": -1, "radius": 1}}})"),
       "d.json#/parts/1/tee/branch/length",
       "'t-branch': must be a positive number between 1e-12 and 1e12, not -1", kBad},
      {pipe_and(
           R"({"name": "t", "tee": {"from": "a.end", "length": 8, "branch": {"direction": [2, 0, 0], "length": 1, "radius": 1}}})"),
       "d.json#/parts/1/tee/branch/direction",
       "'t-branch': the direction must lead off the axis of 't'", kBad},
      {pipe_and(R"({"name": "v", "sphere": 1, "valve": {"from": "a.end", "length": 8}})"),
       "d.json#/parts/1/sphere",
       "unknown key; known here are name, comment, wall, wall_side, insulation, solid, valve"},
      {pipe_and(R"({"name": "v", "valve": {"from": "a.end", "length": 8, "body": {"radius": 1}}})"),
       "d.json#/parts/1/valve/body", "the key 'length' is missing"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
