#include "dupin/io/assembly_json.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"
#include "support/single_piece.h"

namespace dupin {
namespace {

// A document around one list of parts.
std::string document(const std::string& parts) {
  return R"({"units": "mm", "tolerance": 0.05, "parts": [)" + parts + "]}";
}

constexpr const char* kPipe =
    R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 1}})";
constexpr const char* kOther =
    R"({"name": "b", "pipe": {"from": [15, 3, 0], "to": [20, 3, 0], "radius": 2}})";

std::string pipe_and(const std::string& part) { return document(std::string(kPipe) + ", " + part); }

struct Malformed {
  std::string text, where, message;
  Errc code = Errc::parse_failed;
};

// What is not a document of this format, found by reading.
const std::vector<Malformed>& unreadable() {
  static const std::vector<Malformed> rows = {
      {"", "d.json:1:1",
       "syntax error while parsing value - unexpected end of input; expected '[', '{', or a "
       "literal"},
      {"{\"units\": \"mm\",\n  oops}", "d.json:2:3",
       "syntax error while parsing object key - invalid literal; last read: '\"mm\",<U+000A>  o'; "
       "expected string literal"},
      {"{\"units\": \"mm\"} x", "d.json:1:17",
       "syntax error while parsing value - invalid literal; last read: '\"mm\"} x'; expected end "
       "of "
       "input"},
      {"{\"tolerance\": 1e999}", "d.json:1:15", "number overflow parsing '1e999'"},
      {"[]", "d.json#", "must be an object, not array"},
      {"{}", "d.json#", "the key 'units' is missing"},
      {R"({"units": "mm", "units": "m"})", "d.json#/units", "the key occurs twice"},
      {R"({"units": "mm", "parts": [1, {"a/b": {}, "a/b": 1}]})", "d.json#/parts/1/a~1b",
       "the key occurs twice"},
      {R"({"units": "mm", "tolerance": 1, "part": []})", "d.json#/part",
       "unknown key; known here are units, tolerance, segments, comment, parts"},
      {R"({"units": "mile"})", "d.json#/units", "the unit must be mm, cm, m, in or ft, not 'mile'"},
      {R"({"units": 1})", "d.json#/units", "must be a string, not number"},
      {R"({"units": "mm"})", "d.json#", "the key 'tolerance' is missing"},
      {R"({"units": "mm", "tolerance": "1mm"})", "d.json#/tolerance",
       "must be a number, not string"},
      {R"({"units": "mm", "tolerance": 1, "segments": 12.5})", "d.json#/segments",
       "must be a whole number, at least 3"},
      {R"({"units": "mm", "tolerance": 1, "segments": -3})", "d.json#/segments",
       "must be a whole number, at least 3"},
      {R"({"units": "mm", "tolerance": 1, "segments": 1e99})", "d.json#/segments",
       "must be a whole number, at least 3"},
      {R"({"units": "mm", "tolerance": 1, "comment": []})", "d.json#/comment",
       "must be a string, not array"},
      {R"({"units": "mm", "tolerance": 1})", "d.json#", "the key 'parts' is missing"},
      {R"({"units": "mm", "tolerance": 1, "parts": {}})", "d.json#/parts",
       "must be an array, not object"},
      {document("1"), "d.json#/parts/0", "must be an object, not number"},
      {document("{}"), "d.json#/parts/0", "the key 'name' is missing"},
      {document(R"({"name": 5})"), "d.json#/parts/0/name", "must be a string, not number"},
      {document(R"({"name": "a"})"), "d.json#/parts/0",
       "a part must have exactly one of the keys pipe, cone, oblique, elbow, sphere, spline, "
       "cyclic_blend, two_cone_blend, ringed_blend, cyclide_blend, cyclide_chain, cap"},
      {document(
           R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1], "axis": [0, 0, 1]}})"),
       "d.json#/parts/0/pipe/semi_axes", "must be two numbers [along the axis, across it]"},
      {document(
           R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1, 2]}})"),
       "d.json#/parts/0/pipe",
       "from a point, give {from, to, semi_axes, axis} or {from, direction, length, semi_axes, "
       "axis}"},
      {document(
           R"({"name": "a", "cone": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [[1, 2], [1, 2], [1, 2]], "axis": [0, 0, 1]}})"),
       "d.json#/parts/0/cone/semi_axes", "must be the semi-axes at both ends [start, end]"},
      {document(R"({"name": "a", "spline": {"through": [], "closed": false}})"),
       "d.json#/parts/0/spline/closed", "must be true, or left out for a pipe between two ports"},
      {document(R"({"name": "a", "spline": {"from": "b.end", "through": [], "closed": true}})"),
       "d.json#/parts/0/spline",
       "a closed pipe has no ports to begin or end at; leave out 'from' and 'to'"},
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "apex": [0, 0, 1], "slope": 0}}})"),
       "d.json#/parts/0/ringed_blend/to", "give at most one of slope, sphere, apex, ruling, plate"},
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "plate": 1}}})"),
       "d.json#/parts/0/ringed_blend/to/plate", "must be a string, not number"},
      {document(
           R"({"name": "a", "ringed_blend": {"from": "b.end", "to": "c.start", "bidegree": [3, 2]}})"),
       "d.json#/parts/0/ringed_blend/bidegree", "must be [9, 2] or [5, 2]"},
      {document(
           R"({"name": "a", "two_cone_blend": {"from": "b.end", "to": "c.start", "reach": 1}})"),
       "d.json#/parts/0/two_cone_blend/reach", "must be an array, not number"},
      {document(R"({"name": "a", "cap": {"at": "b.end"}, "pipe": {}})"), "d.json#/parts/0",
       "a part must have exactly one of the keys pipe, cone, oblique, elbow, sphere, spline, "
       "cyclic_blend, two_cone_blend, ringed_blend, cyclide_blend, cyclide_chain, cap"},
      {document(R"({"name": "a", "tee": {}})"), "d.json#/parts/0/tee",
       "unknown key; known here are name, comment, pipe, cone, oblique, elbow, sphere, spline, "
       "cyclic_blend, two_cone_blend, ringed_blend, cyclide_blend, cyclide_chain, cap"},
      {document(R"({"name": "a", "pipe": []})"), "d.json#/parts/0/pipe",
       "must be an object, not array"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, 0], "too": [1, 0, 0]}})"),
       "d.json#/parts/0/pipe/too",
       "unknown key; known here are from, to, radius, direction, length"},
      {document(R"({"name": "a", "pipe": {"to": [1, 0, 0], "radius": 1}})"), "d.json#/parts/0/pipe",
       "the key 'from' is missing"},
      {document(R"({"name": "a", "pipe": {"from": 0, "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from", "must be a point [x, y, z] or a port 'part.end', not number"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0]}})"),
       "d.json#/parts/0/pipe",
       "from a point, give {from, to, radius} or {from, direction, length, radius}"},
      {document(R"({"name": "a", "pipe": {"from": "b.end", "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe", "from a port, give {from, length} or {from, to}"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from", "must be three numbers [x, y, z], not 2"},
      {document(R"({"name": "a", "pipe": {"from": [0, 0, null], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/from/2", "must be a number, not null"},
      {document(R"({"name": "a", "pipe": {"from": "b", "length": 1}})"),
       "d.json#/parts/0/pipe/from", "must name a port as 'part.start' or 'part.end', not 'b'"},
      {document(R"({"name": "a", "pipe": {"from": ".end", "length": 1}})"),
       "d.json#/parts/0/pipe/from", "must name a port as 'part.start' or 'part.end', not '.end'"},
      {document(R"({"name": "a", "pipe": {"from": "b.middle", "length": 1}})"),
       "d.json#/parts/0/pipe/from",
       "must name a port as 'part.start' or 'part.end', not 'b.middle'"},
      {document(R"({"name": "a", "cone": {"from": [0, 0, 0], "to": [1, 0, 0], "radii": [1]}})"),
       "d.json#/parts/0/cone/radii", "must be two numbers [start, end]"},
      {document(R"({"name": "a", "cone": {"from": "b.end", "length": 1, "radii": [1, 2]}})"),
       "d.json#/parts/0/cone",
       "from a port, give {from, length, end_radius} or {from, length, end_semi_axes} or {from, "
       "length, "
       "end_semi_axes, axis}"},
      {document(R"({"name": "a", "elbow": {"from": [0, 0, 0], "to": [1, 0, 0]}})"),
       "d.json#/parts/0/elbow",
       "from a point, give {from, direction, radius, bend_radius, angle, toward} or {from, "
       "direction, to, radius} or {from, corner, to, radius}"},
      {document(
           R"({"name": "a", "elbow": {"from": [0, 0, 0], "corner": [0, 0, 0], "to": [1, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/elbow/corner", "the corner must differ from the point at 'from'"},
      {document(R"({"name": "a", "sphere": {"center": [0, 0, 0], "r": 1}})"),
       "d.json#/parts/0/sphere/r", "unknown key; known here are center, radius"},
      {pipe_and(R"({"name": "c", "cap": {"at": 1}})"), "d.json#/parts/1/cap/at",
       "must be a string, not number"},
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
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [[0, 0, 0]]}})"),
       "d.json#/parts/0/cyclide_chain/spheres/0", "must be four numbers [x, y, z, radius], not 3"},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "slope": 1}})"),
       "d.json#/parts/0/cyclide_chain/slope", "a slope needs a direction"},
      {document(
           R"({"name": "c", "cyclide_chain": {"spheres": [], "from": "a.end", "direction": [1, 0, 0]}})"),
       "d.json#/parts/0/cyclide_chain/direction", "a chain from a port has its direction already"},
      {document(
           R"({"name": "c", "cyclide_chain": {"spheres": [], "tangents": [{"sphere": -1, "tangent": [1, 0, 0, 0]}]}})"),
       "d.json#/parts/0/cyclide_chain/tangents/0/sphere", "must be an index, counted from 0"},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "joints": "caps"}})"),
       "d.json#/parts/0/cyclide_chain/joints", "must be \"smooth\" or \"kneecaps\", not \"caps\""},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "wall": 0}})"),
       "d.json#/parts/0/cyclide_chain/wall", "the wall's thickness must be positive"},
  };
  return rows;
}

// What is a document but makes no sense, found by resolving.
const std::vector<Malformed>& senseless() {
  constexpr Errc kBad = Errc::invalid_argument;
  const std::string blend = R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": )";
  const std::string law = R"(, "radius_law": "R1", "k": 8, "l": 8}})";
  const std::string from_a = R"({"name": "c", "elbow": {"from": "a.end", )";
  static const std::vector<Malformed> rows = {
      {R"({"units": "mm", "tolerance": 0, "parts": []})", "d.json#/tolerance",
       "the tolerance must be a positive number, not 0", kBad},
      {R"({"units": "mm", "tolerance": 1, "segments": 2, "parts": []})", "d.json#/segments",
       "a ring needs at least 3 segments, not 2", kBad},
      {document(""), "d.json#/parts", "an assembly needs at least one part", kBad},
      {pipe_and(kPipe), "d.json#/parts/1/name", "'a': the name is already taken by /parts/0", kBad},
      {document(R"({"name": "", "sphere": {"center": [0, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/name", "a part's name must not be empty and not contain a dot", kBad},
      {document(R"({"name": "a.b", "sphere": {"center": [0, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/name", "'a.b': a part's name must not be empty and not contain a dot",
       kBad},
      {document(R"({"name": "s", "sphere": {"center": [0, 0, 0], "radius": -1}})"),
       "d.json#/parts/0/sphere/radius",
       "'s': must be a positive number between 1e-12 and 1e12, not -1", kBad},
      {document(R"({"name": "s", "sphere": {"center": [0, 1e15, 0], "radius": 1}})"),
       "d.json#/parts/0/sphere/center", "'s': coordinates must be finite numbers of at most 1e12",
       kBad},
      {document(R"({"name": "p", "pipe": {"from": [1, 1, 0], "to": [1, 1, 0], "radius": 1}})"),
       "d.json#/parts/0/pipe/to", "'p': the point must differ from the one at 'from'", kBad},
      {document(
           R"({"name": "p", "pipe": {"from": [1, 1, 0], "direction": [0, 0, 0], "length": 1, "radius": 1}})"),
       "d.json#/parts/0/pipe/direction", "'p': the direction must not be zero", kBad},
      {document(
           R"({"name": "p", "pipe": {"from": [1, 1, 0], "direction": [1, 0, 0], "length": 0, "radius": 1}})"),
       "d.json#/parts/0/pipe/length",
       "'p': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {document(R"({"name": "p", "cone": {"from": [1, 1, 0], "to": [1, 0, 0], "radii": [1, 0]}})"),
       "d.json#/parts/0/cone/radii/1",
       "'p': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {pipe_and(R"({"name": "c", "cone": {"from": "a.end", "length": 3, "end_radius": -2}})"),
       "d.json#/parts/1/cone/end_radius",
       "'c': must be a positive number between 1e-12 and 1e12, not -2", kBad},
      {pipe_and(R"({"name": "c", "cap": {"at": "d.end"}})"), "d.json#/parts/1/cap/at",
       "'c': there is no part named 'd'", kBad},
      {document(
           R"({"name": "s", "sphere": {"center": [0, 0, 0], "radius": 1}}, {"name": "c", "cap": {"at": "s.end"}})"),
       "d.json#/parts/1/cap/at", "'c': 's' is a sphere and has no ports", kBad},
      {pipe_and(R"({"name": "c", "cap": {"at": "a.end"}}, {"name": "d", "cap": {"at": "a.end"}})"),
       "d.json#/parts/2/cap/at", "'d': the port 'a.end' is already taken by 'c'", kBad},
      {pipe_and(kOther + (", " + blend) + R"("b.start")" + law +
                R"(, {"name": "d", "pipe": {"from": "b.start", "length": 2}})"),
       "d.json#/parts/3/pipe/from", "'d': the port 'b.start' is already taken by 'c'", kBad},
      {pipe_and(blend + R"("a.end")" + law), "d.json#/parts/1/cyclic_blend/to",
       "'c': the port 'a.end' is already taken by 'c'", kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "length": 2}},
                   {"name": "d", "pipe": {"from": "c.start", "length": 2}})"),
       "d.json#/parts/2/pipe/from", "'d': the port 'c.start' is already taken by 'a'", kBad},
      {document(R"({"name": "c", "pipe": {"from": "c.end", "length": 2}})"),
       "d.json#/parts/0/pipe/from",
       "'c': parts must not begin at each other in a circle: 'c' -> 'c'", kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "e.end", "length": 2}},
                   {"name": "d", "pipe": {"from": "c.end", "length": 2}},
                   {"name": "e", "pipe": {"from": "d.end", "length": 2}})"),
       "d.json#/parts/1/pipe/from",
       "'c': parts must not begin at each other in a circle: 'c' -> 'e' -> 'd' -> 'c'", kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [8, 0, 0]}})"),
       "d.json#/parts/1/pipe/to", "'c': the point must lie ahead of 'a.end', not 1 behind it",
       kBad},
      {pipe_and(R"({"name": "c", "pipe": {"from": "a.end", "to": [10, 0.25, 0]}})"),
       "d.json#/parts/1/pipe/to",
       "'c': the point is 0.25 off the pipe's axis, more than the tolerance of 0.05 allows", kBad},
      {pipe_and(from_a + R"("bend_radius": 2, "angle": 360, "toward": [0, 1, 0]}})"),
       "d.json#/parts/1/elbow/angle",
       "'c': an elbow's angle must lie between 0 and 360 degrees, not at 360", kBad},
      {pipe_and(from_a + R"("bend_radius": 2, "angle": 90, "toward": [2, 0, 0]}})"),
       "d.json#/parts/1/elbow/toward",
       "'c': the direction must have a part across the direction of travel", kBad},
      {pipe_and(from_a + R"("to": [12, 0, 0]}})"), "d.json#/parts/1/elbow/to",
       "'c': the point lies on the axis; a pipe leads there", kBad},
      {pipe_and(from_a + R"("corner": [11, 1, 0], "to": [11, 3, 0]}})"),
       "d.json#/parts/1/elbow/corner",
       "'c': the corner is 1 off the axis, more than the tolerance of 0.05 allows", kBad},
      {pipe_and(from_a + R"("corner": [11, 0, 0], "to": [13, 0, 0]}})"), "d.json#/parts/1/elbow/to",
       "'c': the corner is none: both legs lie on one line", kBad},
      {document(
           R"({"name": "e", "elbow": {"from": [0, 0, 0], "corner": [2, 0, 0], "to": [2, 3, 0], "radius": 1}})"),
       "d.json#/parts/0/elbow/corner",
       "'e': the legs from the corner are 2 and 3 long, more than the tolerance of 0.05 allows",
       kBad},
      {pipe_and(R"({"name": "c", "cone": {"from": "a.end", "length": 2, "end_radius": 2}},
                   {"name": "b", "pipe": {"from": [15, 3, 0], "to": [20, 3, 0], "radius": 2}},
                   {"name": "d", "cyclic_blend": {"from": "c.end", "to": "b.start", "radius_law": "R2", "k": 5, "l": 5}})"),
       "d.json#/parts/3",
       "'d': the radius law R2 goes with tangent continuity between cylinders only; take R1", kBad},
  };
  return rows;
}

void expect_fault(const Malformed& row) {
  try {
    (void)resolve(parse_assembly(row.text, "d.json"));
    ADD_FAILURE() << "accepted: " << row.text;
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), row.where) << row.text;
    EXPECT_EQ(error.what(), row.where + ": " + row.message) << row.text;
    EXPECT_EQ(name(error.code()), name(row.code)) << row.text;
  }
}

TEST(AssemblyJson, refuses_what_is_not_a_document) {
  for (const auto& row : unreadable()) {
    expect_fault(row);
  }
}

TEST(AssemblyJson, refuses_documents_that_make_no_sense) {
  for (const auto& row : senseless()) {
    expect_fault(row);
  }
}

TEST(AssemblyJson, refuses_at_least_forty_kinds_of_documents) {
  EXPECT_GE(unreadable().size() + senseless().size(), 40U);
}

Assembly example(const std::string& name) {
  return read_assembly(std::filesystem::path(DUPIN_SOURCE_DIR) / "examples" / name);
}

TEST(AssemblyJson, reads_the_reducer) {
  const Assembly reducer = example("reducer.json");
  EXPECT_EQ(reducer.unit, Unit::millimetre);
  EXPECT_EQ(reducer.tolerance, 0.05);
  EXPECT_FALSE(reducer.segments);
  ASSERT_EQ(reducer.parts.size(), 3U);
  const auto& inlet = std::get<PipeBetween>(reducer.parts[0].shape);
  EXPECT_EQ(inlet.from, Vec3(-10, 0, 0));
  EXPECT_EQ(inlet.to, Vec3(0, 0, 0));
  EXPECT_EQ(inlet.radius, 1);
  const auto& outlet = std::get<PipeAlong>(reducer.parts[1].shape);
  EXPECT_EQ(std::get<Place>(outlet.from).direction, Vec3(1, 2, 10));
  EXPECT_EQ(outlet.length, 10);
  EXPECT_EQ(reducer.parts[2].name, "blend");
  const auto& blend = std::get<CyclicBlendBetween>(reducer.parts[2].shape);
  EXPECT_EQ(blend.from, (PortReference{"inlet", End::end}));
  EXPECT_EQ(blend.to, (PortReference{"outlet", End::start}));
  EXPECT_EQ(blend.options.radius_law, BlendLaw::r1);
  EXPECT_EQ(blend.options.k, 10);
  EXPECT_EQ(blend.options.l, 20);
}

TEST(AssemblyJson, reads_every_form_of_every_part) {
  const Assembly assembly = parse_assembly(document(R"(
    {"name": "a", "comment": "why", "elbow": {"from": [0, 0, 0], "direction": [1, 0, 0], "radius": 1, "bend_radius": 3, "angle": 90, "toward": [0, 1, 0]}},
    {"name": "b", "elbow": {"from": "a.end", "bend_radius": 3, "angle": 45, "toward": [0, 0, 1]}},
    {"name": "c", "elbow": {"from": "b.end", "to": [3, 9, 9]}},
    {"name": "d", "elbow": {"from": [50, 0, 0], "direction": [1, 0, 0], "to": [53, 3, 0], "radius": 1}},
    {"name": "e", "elbow": {"from": [70, 0, 0], "corner": [73, 0, 0], "to": [73, 3, 0], "radius": 1}},
    {"name": "f", "cone": {"from": "e.end", "length": 3, "end_radius": 2}},
    {"name": "g", "cone": {"from": [90, 0, 0], "to": [93, 0, 0], "radii": [1, 2]}},
    {"name": "h", "cone": {"from": [110, 0, 0], "direction": [0, 1, 0], "length": 3, "radii": [1, 2]}},
    {"name": "i", "pipe": {"from": "f.end", "to": [73, 9, 0]}},
    {"name": "j", "cap": {"at": "i.end"}},
    {"name": "l", "elbow": {"from": "g.end", "corner": [95, 0, 0], "to": [95, 0, -2]}},
    {"name": "k", "sphere": {"center": [130, 0, 0], "radius": 2}})"));
  const auto resolved = resolve(assembly);
  ASSERT_EQ(resolved.parts.size(), 11U);
  const auto end = [&](std::size_t part) {
    return test::single_piece<RingedSurface>(resolved.parts[part].shape).end;
  };
  const double half = std::sqrt(0.5);
  EXPECT_EQ(end(0).center, Vec3(3, 3, 0));
  EXPECT_EQ(end(0).normal, Vec3(0, 1, 0));
  EXPECT_LT((end(1).center - Vec3(3, 3 + 3 * half, 3 - 3 * half)).norm(), 1e-15);
  EXPECT_LT((end(1).normal - Vec3(0, half, half)).norm(), 1e-15);
  EXPECT_EQ(end(2).center, Vec3(3, 9, 9));
  EXPECT_EQ(end(3).normal, Vec3(0, 1, 0));
  EXPECT_EQ(end(4).center, Vec3(73, 3, 0));
  EXPECT_EQ(end(5).radius, 2);
  EXPECT_DOUBLE_EQ(end(6).slope, 1.0 / 3);
  EXPECT_EQ(end(7).center, Vec3(110, 3, 0));
  EXPECT_EQ(end(8).center, Vec3(73, 9, 0));
  EXPECT_EQ(end(9), (Ring{Vec3(95, 0, -2), Vec3(0, 0, -1), 2}));
  EXPECT_EQ(resolved.parts[8].end_names[1], "j");
  EXPECT_EQ(std::get<Sphere>(resolved.parts[10].shape).radius, 2);
}

TEST(AssemblyJson, names_a_file_that_is_not_there) {
  try {
    (void)read_assembly("/nowhere/to/be/found.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::io_failed);
    EXPECT_STREQ(error.what(), "/nowhere/to/be/found.json: the file cannot be read");
  }
}

}  // namespace
}  // namespace dupin
