#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::read_last;

constexpr const char* kThree =
    R"({"name": "a", "pipe": {"from": [9, 0, 0], "to": [5, 0, 0], "radius": 1}},
       {"name": "b", "pipe": {"from": [0, 5, 0], "to": [0, 9, 0], "radius": 1}},
       {"name": "c", "pipe": {"from": [0, 0, 9], "to": [0, 0, 5], "radius": 0.5}}, )";

std::string three_and(const std::string& part) { return document(kThree + part); }

constexpr const char* kHub =
    R"({"name": "hub", "junction": {"ends": ["a.end", "b.start", "c.end"]}})";

TEST(JunctionKey, reads_its_ends_and_what_is_chosen) {
  const auto shape = read_last<JunctionOfPorts>(
      three_and(R"({"name": "hub", "junction": {"ends": ["a.end", "b.start", "c.end"],
          "center": [0, 0.5, 0], "radius": 2, "cap_angles": [40, 45, 30], "smoothness": 0.5}})"));
  ASSERT_EQ(shape.ends.size(), 3U);
  EXPECT_EQ(shape.ends[1], (PortReference{"b", End::start}));
  EXPECT_EQ(shape.options.center, std::optional(Vec3(0, 0.5, 0)));
  EXPECT_EQ(shape.options.radius, std::optional(2.0));
  EXPECT_EQ(shape.options.smoothness, 0.5);
  ASSERT_EQ(shape.options.cap_angles.size(), 3U);
  EXPECT_NEAR(shape.options.cap_angles[1], std::numbers::pi / 4, 1e-15);
}

TEST(JunctionKey, has_arms_that_share_their_rings_with_the_ports) {
  const auto resolved = resolve(parse_assembly(three_and(kHub)));
  ASSERT_EQ(resolved.junctions.size(), 1U);
  ASSERT_EQ(resolved.parts.size(), 6U) << "three pipes and three arms";
  const BuriedEnds buried(resolved);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t arm = resolved.junctions[0].arms[i];
    EXPECT_EQ(resolved.parts[arm].name, "hub." + std::to_string(i + 1));
    const auto neighbour = resolved.parts[arm].joined[0];
    ASSERT_TRUE(neighbour.has_value());
    EXPECT_EQ(neighbour->part, i);
    EXPECT_EQ(*port_ring(resolved.parts[arm].shape, End::start),
              flipped(*port_ring(resolved.parts[i].shape, neighbour->end)));
    EXPECT_TRUE(buried.contains({arm, End::end}));
    EXPECT_FALSE(buried.contains({arm, End::start}));
  }
}

TEST(JunctionKey, joins_its_parts_into_one_solid) {
  const Built built = build(parse_assembly(three_and(kHub)));
  EXPECT_EQ(built.pieces, 1U);
  ASSERT_EQ(built.parts.size(), 7U);
  const PartReport& hub = built.parts[3];
  EXPECT_EQ(hub.name, "hub");
  EXPECT_EQ(hub.kind, "junction");
  EXPECT_EQ(hub.construction.substr(0, 14), "hub of radius ");
  EXPECT_GT(hub.triangles, 50U);
  EXPECT_LE(hub.error_bound, 0.05);
  EXPECT_EQ(built.parts[4].name, "hub.1");
  EXPECT_LT(built.parts[4].start_tangency.value(), 1e-12);
  EXPECT_GT(built.parts[4].margin_lower.value(), 0);
  EXPECT_LE(built.parts[4].error_bound, 0.05);
  const TriMesh mesh = to_mesh(built.solid).mesh();
  for (const std::string label : {"a", "a.start", "hub", "hub.3"}) {
    EXPECT_NE(std::ranges::find(mesh.names, label), mesh.names.end()) << label;
  }
}

TEST(JunctionKey, may_join_the_ends_of_other_junctions_pipes) {
  std::string parts = kHub;
  parts += R"(, {"name": "d", "pipe": {"from": [44, 0, 16], "to": [35, 0, 10], "radius": 0.7}},
                {"name": "e", "pipe": {"from": [44, 0, -16], "to": [35, 0, -10], "radius": 0.7}},
                {"name": "far", "junction": {"ends": ["d.end", "a.start", "e.end"]}})";
  const Built built = build(parse_assembly(three_and(parts)));
  EXPECT_EQ(built.pieces, 1U);
  EXPECT_EQ(built.parts.size(), 13U);
}

TEST(JunctionKey, may_join_both_ends_of_one_way_round) {
  const Built built = build(parse_assembly(document(
      R"({"name": "a", "pipe": {"from": [12, 0, 0], "to": [30, 0, 0], "radius": 2}},
         {"name": "b", "elbow": {"from": "a.end", "bend_radius": 20, "angle": 90, "toward": [0, 1, 0]}},
         {"name": "c", "elbow": {"from": "b.end", "bend_radius": 20, "angle": 90, "toward": [-1, 0, 0]}},
         {"name": "d", "pipe": {"from": "c.end", "length": 50}},
         {"name": "e", "elbow": {"from": "d.end", "bend_radius": 20, "angle": 90, "toward": [0, -1, 0]}},
         {"name": "f", "elbow": {"from": "e.end", "bend_radius": 20, "angle": 90, "toward": [1, 0, 0]}},
         {"name": "g", "pipe": {"from": [0, 0, 20], "to": [0, 0, 12], "radius": 3}},
         {"name": "hub", "junction": {"ends": ["a.start", "f.end", "g.end"]}})")));
  EXPECT_EQ(built.runs, 2U);
  const Report report = check(to_mesh(built.solid).mesh());
  EXPECT_EQ(report.euler_number, 0) << "a ring with a branch";
}

// An elliptical end, and one of a cylinder along (-1, -6, 0) whose circles lie across (0, 1, 0).
constexpr const char* kOthers =
    R"({"name": "a", "pipe": {"from": [30, 0, 0], "to": [20, 0, 0], "semi_axes": [2, 1], "axis": [0, 0, 1]}},
       {"name": "b", "oblique": {"from": [6, 44, 0], "to": [4, 32, 0], "normal": [0, -1, 0], "radii": [1, 1]}},
       {"name": "c", "pipe": {"from": [-30, 0, 0], "to": [-20, 0, 0], "radius": 1}},
       {"name": "hub", "junction": {"ends": ["a.end", "b.end", "c.end"]}})";

TEST(JunctionKey, leads_from_ellipses_and_oblique_ends_to_circles) {
  const Assembly assembly = parse_assembly(document(kOthers));
  const auto resolved = resolve(assembly);
  ASSERT_EQ(resolved.parts.size(), 8U);
  for (const std::uint32_t i : {0U, 1U}) {
    const std::uint32_t arm = resolved.junctions[0].arms[i];
    EXPECT_EQ(resolved.parts[arm].name, "hub." + std::to_string(i + 1));
    ASSERT_TRUE(resolved.parts[arm].joined[0].has_value());
    const std::uint32_t transition = resolved.parts[arm].joined[0]->part;
    const ResolvedPart& part = resolved.parts[transition];
    EXPECT_EQ(part.name, "hub." + std::to_string(i + 1) + ".transition");
    EXPECT_EQ(part.joined[1], (EndIndex{arm, End::start}));
    EXPECT_EQ(part.joined[0], (EndIndex{i, End::end}));
    EXPECT_EQ(resolved.parts[i].joined[1], (EndIndex{transition, End::start}));
    EXPECT_EQ(*port_ring(part.shape, End::start),
              flipped(*port_ring(resolved.parts[i].shape, End::end)));
    EXPECT_EQ(*port_ring(part.shape, End::end),
              flipped(*port_ring(resolved.parts[arm].shape, End::start)));
    EXPECT_FALSE(port_ring(part.shape, End::end)->ellipse);
  }
  EXPECT_EQ(resolved.parts[resolved.junctions[0].arms[2]].joined[0], (EndIndex{2, End::end}));
  const Built built = build(assembly);
  EXPECT_EQ(built.pieces, 1U);
  EXPECT_EQ(check(to_mesh(built.solid).mesh()).euler_number, 2);
  for (const PartReport& part : built.parts) {
    EXPECT_LE(part.error_bound, 0.05) << part.name;
    EXPECT_LT(part.start_tangency.value_or(0), 1e-9) << part.name;
    EXPECT_LT(part.end_tangency.value_or(0), 1e-9) << part.name;
  }
}

TEST(JunctionKey, says_where_there_is_no_room_for_transitions) {
  try {
    (void)resolve(parse_assembly(document(
        R"({"name": "a", "pipe": {"from": [9, 0, 0], "to": [2.5, 0, 0], "semi_axes": [2, 1], "axis": [0, 0, 1]}},
           {"name": "b", "pipe": {"from": [-9, 0, 0], "to": [-2.5, 0, 0], "radius": 1}},
           {"name": "c", "pipe": {"from": [0, 9, 0], "to": [0, 2.5, 0], "radius": 1}},
           {"name": "hub", "junction": {"ends": ["a.end", "b.end", "c.end"]}})")));
    FAIL() << "there is no room";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_NE(error.message().find(
                  "with transitions from its elliptical and oblique ends to circles: end "),
              std::string::npos)
        << error.message();
  }
}

TEST(JunctionKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const Malformed rows[] = {
      {three_and(R"({"name": "h", "junction": {"ends": "a.end"}})"),
       "d.json#/parts/3/junction/ends", "must be an array, not string"},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.end", "b.start"], "size": 1}})"),
       "d.json#/parts/3/junction/size",
       "unknown key; known here are ends, center, radius, cap_angles, smoothness"},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.end", "z.start"]}})"),
       "d.json#/parts/3/junction/ends", "'h': there is no part named 'z'", kBad},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.end", "a.end"]}})"),
       "d.json#/parts/3/junction/ends", "'h': the port 'a.end' is already taken by 'h'", kBad},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.end"]}})"), "d.json#/parts/3",
       "'h': a junction needs at least two ends, not 1", kBad},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.end", "b.start"]}},
                    {"name": "g", "pipe": {"from": "h.end", "length": 1}})"),
       "d.json#/parts/4/pipe/from", "'g': 'h' is a junction and has no ports", kBad},
      {three_and(R"({"name": "h", "junction": {"ends": ["a.start", "b.start"]}})"),
       "d.json#/parts/3: end 1",
       "'h': end 1 does not face the hub's centre (0, 0, 0): turn it, or choose the centre",
       Errc::infeasible_blend},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
