#include "dupin/io/assembly_json.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"
#include "io/json/document_fault.h"
#include "support/single_piece.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::kOther;
using test::kPipe;
using test::Malformed;
using test::pipe_and;

// "pipe, cone, ...": all keys that a part may have.
std::string all_keys() {
  std::string result;
  for (const KeyName& key : PartKeys::kNames) {
    result += (result.empty() ? "" : ", ") + std::string(key.view());
  }
  return result + ", tee, valve";
}

// What is not a document of this format, found by reading. Faults of a part stand in the test of
// its key.
const std::vector<Malformed>& unreadable() {
  static const std::vector<Malformed> rows = {
      {"", "d.json:1:1",
       "syntax error while parsing value - unexpected end of input; expected '[', '{', or a "
       "literal"},
      {" \n solid plate\nfacet", "d.json:2:2",
       "found 'solid plate\\x0aface' at the start, expected a document, which is JSON and begins "
       "with '{'"},
      {std::string(100, '(') + "{[[[", "d.json:1:1",
       "found '((((((((((((((((' at the start, expected a document, which is JSON and begins with "
       "'{'"},
      {"\xEF\xBB\xBFOFF", "d.json:1:4",
       "found 'OFF' at the start, expected a document, which is JSON and begins with '{'"},
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
       "unknown key; known here are $schema, units, tolerance, segments, wall, wall_side, "
       "insulation, "
       "patches, comment, values, parts"},
      {R"({"units": "mile"})", "d.json#/units", "the unit must be mm, cm, m, in or ft, not 'mile'"},
      {R"({"units": 1})", "d.json#/units", "must be a string, not number"},
      {R"({"units": "mm"})", "d.json#", "the key 'tolerance' is missing"},
      {R"({"units": "mm", "tolerance": "1mm"})", "d.json#/tolerance",
       "must be a number, not string"},
      {R"({"units": "mm", "tolerance": 1, "segments": 12.5})", "d.json#/segments",
       "must be a whole number from 3 to 1000000"},
      {R"({"units": "mm", "tolerance": 1, "segments": -3})", "d.json#/segments",
       "must be a whole number from 3 to 1000000"},
      {R"({"units": "mm", "tolerance": 1, "segments": 1e99})", "d.json#/segments",
       "must be a whole number from 3 to 1000000"},
      {R"({"units": "mm", "tolerance": 1, "parts": [{"comment": 1, "parts": []}]})",
       "d.json#/parts/0/comment", "must be a string, not number"},
      {R"({"units": "mm", "tolerance": 1, "wall": "thin"})", "d.json#/wall",
       "must be a number, not string"},
      {R"({"units": "mm", "tolerance": 1, "parts": [{"name": "a", "wall": []}]})",
       "d.json#/parts/0/wall", "must be a number, not array"},
      {R"({"units": "mm", "tolerance": 1, "parts": [{"name": "a", "solid": 1}]})",
       "d.json#/parts/0/solid", "must be true or false"},
      {R"({"units": "mm", "tolerance": 1, "comment": []})", "d.json#/comment",
       "must be a string, not array"},
      {R"({"units": "mm", "tolerance": 1})", "d.json#", "the key 'parts' is missing"},
      {R"({"units": "mm", "tolerance": 1, "parts": {}})", "d.json#/parts",
       "must be an array, not object"},
      {document("1"), "d.json#/parts/0", "must be an object, not number"},
      {document("{}"), "d.json#/parts/0", "the key 'name' is missing"},
      {document(R"({"name": 5})"), "d.json#/parts/0/name", "must be a string, not number"},
      {document(R"({"name": "a"})"), "d.json#/parts/0",
       "a part must have exactly one of the keys " + all_keys()},
      {document(R"({"name": "a", "cap": {"at": "b.end"}, "pipe": {}})"), "d.json#/parts/0",
       "a part must have exactly one of the keys " + all_keys()},
      {document(R"({"name": "a", "tube": {}})"), "d.json#/parts/0/tube",
       "unknown key; known here are name, comment, wall, wall_side, insulation, solid, "
       "component, colour, " +
           all_keys()},
      {document(R"({"name": "a", "pipe": {"from": "b", "length": 1}})"),
       "d.json#/parts/0/pipe/from", "must name a port as 'part.start' or 'part.end', not 'b'"},
      {document(R"({"name": "a", "pipe": {"from": ".end", "length": 1}})"),
       "d.json#/parts/0/pipe/from", "must name a port as 'part.start' or 'part.end', not '.end'"},
      {document(R"({"name": "a", "pipe": {"from": "b.middle", "length": 1}})"),
       "d.json#/parts/0/pipe/from",
       "must name a port as 'part.start' or 'part.end', not 'b.middle'"},
  };
  return rows;
}

// What is a document but makes no sense, found by resolving.
const std::vector<Malformed>& senseless() {
  constexpr Errc kBad = Errc::invalid_argument;
  const std::string blend = R"({"name": "c", "cyclic_blend": {"from": "a.end", "to": )";
  const std::string law = R"(, "radius_law": "R1", "k": 8, "l": 8}})";
  static const std::vector<Malformed> rows = {
      {R"({"units": "mm", "tolerance": 0, "parts": []})", "d.json#/tolerance",
       "the tolerance must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {R"({"units": "mm", "tolerance": 1000000100000, "parts": []})", "d.json#/tolerance",
       "the tolerance must be a positive number between 1e-12 and 1e12, not 1.00001e+12", kBad},
      {R"({"units": "mm", "tolerance": 1, "segments": 2, "parts": []})", "d.json#/segments",
       "a ring needs 3 to 1000000 segments, not 2", kBad},
      {R"({"units": "mm", "tolerance": 1, "segments": 1000001, "parts": []})", "d.json#/segments",
       "a ring needs 3 to 1000000 segments, not 1000001", kBad},
      {document(""), "d.json#/parts", "an assembly needs at least one part", kBad},
      {pipe_and(kPipe), "d.json#/parts/1/name", "'a': the name is already taken by /parts/0", kBad},
      {document(R"({"name": "", "sphere": {"center": [0, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/name", "a part's name must not be empty and not contain a dot", kBad},
      {document(R"({"name": "a.b", "sphere": {"center": [0, 0, 0], "radius": 1}})"),
       "d.json#/parts/0/name", "'a.b': a part's name must not be empty and not contain a dot",
       kBad},
      {pipe_and(R"({"name": "c", "cap": {"at": "d.end"}})"), "d.json#/parts/1/cap/at",
       "'c': there is no part named 'd'", kBad},
      {pipe_and(R"({"name": "c", "cap": {"at": "a.end"}}, {"name": "d", "cap": {"at": "a.end"}})"),
       "d.json#/parts/2/cap/at", "'d': the port 'a.end' is already taken by 'c'", kBad},
      {pipe_and(blend + R"("a.end")" + law), "d.json#/parts/1/cyclic_blend/to",
       "'c': the port 'a.end' is already taken by 'c'", kBad},
      {pipe_and(kOther + (", " + blend) + R"("b.start")" + law +
                R"(, {"name": "d", "pipe": {"from": "b.start", "length": 2}})"),
       "d.json#/parts/3/pipe/from", "'d': the port 'b.start' is already taken by 'c'", kBad},
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
  };
  return rows;
}

TEST(AssemblyJson, reads_walls_of_the_document_and_of_parts) {
  const Assembly assembly =
      parse_assembly(R"({"units": "mm", "tolerance": 1, "wall": 0.5, "parts": [
    {"name": "a", "wall": 0.25, "sphere": {"center": [0, 0, 0], "radius": 1}},
    {"name": "b", "solid": true, "sphere": {"center": [9, 0, 0], "radius": 1}},
    {"name": "c", "solid": false, "sphere": {"center": [9, 9, 0], "radius": 1}}]})");
  EXPECT_EQ(assembly.wall, 0.5);
  EXPECT_EQ(assembly.parts[0].wall, 0.25);
  EXPECT_FALSE(assembly.parts[0].solid);
  EXPECT_EQ(assembly.parts[1].wall, std::nullopt);
  EXPECT_TRUE(assembly.parts[1].solid);
  EXPECT_FALSE(assembly.parts[2].solid);
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
  return read_assembly(test::source_folder() / "examples" / name);
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
    EXPECT_STREQ(error.what(),
                 "/nowhere/to/be/found.json: cannot read the file: No such file or directory");
  }
}

}  // namespace
}  // namespace dupin
