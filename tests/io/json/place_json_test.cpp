#include "dupin/io/place_json.h"

#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/blends/build.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kSource = test::source_folder();

Placement scaling(double factor) {
  Placement placement;
  placement.scale(factor);
  return placement;
}

Placement turning(double degrees) {
  Placement placement;
  placement.rotate(Vec3(0, 0, 1), degrees, Vec3(1, 2, 3));
  return placement;
}

std::string document(const std::string& parts) {
  return R"({"units": "mm", "tolerance": 0.5, "parts": [)" + parts + "]}";
}

TEST(PlaceJson, changes_numbers_by_their_meaning_and_no_other_character) {
  const std::string text = document(R"(
    {"name": "[1, 2, 3] \"k\": 4", "comment": "from: [1,2,3]", "pipe" : {"from":[1,2 , 3], "to": [1, 2, 9], "radius": 2}},
    {"name": "b", "elbow": {"from": "[1, 2, 3] \"k\": 4.end", "bend_radius": 8, "angle": 30, "toward": [1, 0, 0]}})");
  Placement placement;
  placement.rotate(Vec3::UnitZ(), 90);
  placement.scale(2);
  placement.translate(Vec3(0.5, 0, 0));
  const PlacedDocument after = placed_document(text, "d.json", placement);
  EXPECT_EQ(after.text, R"({"units": "mm", "tolerance": 1.0, "parts": [
    {"name": "[1, 2, 3] \"k\": 4", "comment": "from: [1,2,3]", "pipe" : {"from":[-3.5, 2.0, 6.0], "to": [-3.5, 2.0, 18.0], "radius": 4.0}},
    {"name": "b", "elbow": {"from": "[1, 2, 3] \"k\": 4.end", "bend_radius": 16.0, "angle": 30, "toward": [0.0, 1.0, 0.0]}}]})");
  EXPECT_TRUE(after.is_exact);
  EXPECT_EQ(after.largest_move, 0);
  EXPECT_EQ(placed_document(text, "d.json", Placement()).text, text);
}

TEST(PlaceJson, keeps_a_byte_order_mark) {
  const std::string mark = "\xEF\xBB\xBF";
  Placement placement;
  placement.translate(Vec3(0.5, 0, 0));
  for (const std::string x : {"1", "\"=1\""}) {
    const std::string text = document(R"({"name": "a", "pipe": {"from": [)" + x +
                                      R"(, 2, 3], "to": [1, 2, 9], "radius": 2}})");
    EXPECT_EQ(placed_document(mark + text, "d.json", placement).text,
              mark + placed_document(text, "d.json", placement).text);
  }
}

TEST(PlaceJson, says_what_was_rounded) {
  const std::string text =
      document(R"({"name": "a", "sphere": {"center": [0.1, 0, 0], "radius": 1}})");
  Placement placement;
  placement.translate(Vec3(1e6, 0, 0));
  const PlacedDocument moved = placed_document(text, "d.json", placement);
  EXPECT_FALSE(moved.is_exact);
  EXPECT_GT(moved.largest_move, 0);
  EXPECT_LT(moved.largest_move, 0x1p-32);
  const PlacedDocument turned = placed_document(text, "d.json", turning(30));
  EXPECT_FALSE(turned.is_exact);
  EXPECT_GT(turned.largest_move, 0);
  EXPECT_LT(turned.largest_move, 1e-13);
}

TEST(PlaceJson, knows_every_key_of_a_document) {
  // A key that is new here: say in place_json.cpp what its numbers are, and cover it below.
  const std::set<std::string> known = {"$schema",
                                       "angle",
                                       "apex",
                                       "at",
                                       "avoid",
                                       "axis",
                                       "ball",
                                       "bend_radius",
                                       "between",
                                       "bidegree",
                                       "body",
                                       "box",
                                       "branch",
                                       "cap",
                                       "cap_angles",
                                       "capsule",
                                       "center",
                                       "class",
                                       "clearance",
                                       "closed",
                                       "colour",
                                       "comment",
                                       "component",
                                       "cone",
                                       "continuity",
                                       "cope",
                                       "corner",
                                       "crown",
                                       "cyclic_blend",
                                       "cyclide_blend",
                                       "cyclide_chain",
                                       "depth",
                                       "direction",
                                       "elbow",
                                       "end",
                                       "end_radius",
                                       "end_semi_axes",
                                       "ends",
                                       "fillet",
                                       "flange",
                                       "for",
                                       "form",
                                       "from",
                                       "head",
                                       "inside_diameter",
                                       "insulation",
                                       "joints",
                                       "junction",
                                       "k",
                                       "kind",
                                       "knuckle",
                                       "l",
                                       "length",
                                       "line",
                                       "m",
                                       "mesh",
                                       "name",
                                       "neighbours",
                                       "normal",
                                       "oblique",
                                       "on",
                                       "outside_diameter",
                                       "part",
                                       "parts",
                                       "patches",
                                       "pipe",
                                       "plate",
                                       "point",
                                       "radii",
                                       "radius",
                                       "radius_law",
                                       "reach",
                                       "ringed_blend",
                                       "ruling",
                                       "schedule",
                                       "segments",
                                       "semi_axes",
                                       "size",
                                       "slope",
                                       "smoothness",
                                       "solid",
                                       "sphere",
                                       "spheres",
                                       "spline",
                                       "stem",
                                       "tangent",
                                       "tangents",
                                       "tee",
                                       "thickness",
                                       "through",
                                       "to",
                                       "tolerance",
                                       "toward",
                                       "two_cone_blend",
                                       "units",
                                       "values",
                                       "valve",
                                       "w",
                                       "wall",
                                       "wall_side"};
  std::set<std::string> found;
  const auto collect = [&](const auto& self, const Json& json) -> void {
    for (const auto& [key, value] : json.items()) {
      if (key == "properties") {
        for (const auto& property : value.items()) {
          found.insert(property.key());
        }
      }
      if (value.is_structured()) {
        self(self, value);
      }
    }
  };
  collect(collect, Json::parse(read_file(kSource / "io/assembly.schema.json")));
  EXPECT_EQ(found, known);
}

/// Twice the size is the same numbers with other exponents, so that all that follows is the same.
void expect_like_itself(const std::string& text, const std::string& name) {
  SCOPED_TRACE(name);
  const PlacedDocument twice = placed_document(text, name, scaling(2));
  EXPECT_TRUE(twice.is_exact);
  const Built small = build(parse_assembly(text, name));
  const Built large = build(parse_assembly(twice.text, name));
  EXPECT_EQ(large.solid.triangle_count(), small.solid.triangle_count());
  EXPECT_NEAR(large.solid.volume() / small.solid.volume(), 8, 1e-9);
  const std::string slanted = placed_document(text, name, turning(33)).text;
  EXPECT_NEAR(build(parse_assembly(slanted, name)).solid.volume() / small.solid.volume(), 1, 0.05);
}

TEST(PlaceJson, documents_put_elsewhere_build_as_they_did) {
  for (const std::string name : {"crane-hook", "junction", "oblique-nozzle", "oval-duct",
                                 "reducing-elbow", "two-cones", "way-points"}) {
    expect_like_itself(read_file(kSource / "examples" / (name + ".json")), name);
  }
}

TEST(PlaceJson, four_quarter_turns_are_none) {
  const std::string text = read_file(kSource / "examples/crane-hook.json");
  std::string turned = text;
  for (int i = 0; i < 4; ++i) {
    const PlacedDocument next = placed_document(turned, "d.json", turning(90));
    EXPECT_LT(next.largest_move, 1e-14) << "about a point that is none of the document's";
    turned = next.text;
  }
  EXPECT_NEAR(build(parse_assembly(turned, "d.json")).solid.volume() /
                  build(parse_assembly(text, "d.json")).solid.volume(),
              1, 1e-9);
}

TEST(PlaceJson, parts_that_no_example_has_are_put_there_too) {
  expect_like_itself(document(R"({"name": "a", "ringed_blend": {
    "from": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 2, "sphere": [0, 0, -1]},
    "to": {"center": [1, 0, 8], "direction": [0, 0, 1], "radius": 1, "slope": 0}}})"),
                     "sphere");
  expect_like_itself(document(R"({"name": "a", "cone": {"from": [0, 0, 0], "to": [0, 0, 8],
    "semi_axes": [[2, 1], [3, 1]], "axis": [1, 0, 0]}})"),
                     "elliptic cone");
  expect_like_itself(document(R"({"name": "a", "cyclide_chain": {"wall": 0.25,
    "direction": [1, 0, 0], "spheres": [[0, 0, 0, 1], [2, 0.5, 0, 1], [4, 2, 0, 1]]}})"),
                     "hollow chain");
}

TEST(PlaceJson, refuses_what_is_no_document_or_leaves_the_doubles) {
  EXPECT_THROW((void)placed_document("{}", "d.json", Placement()), Error);
  EXPECT_THROW((void)placed_document("[1, 2", "d.json", Placement()), Error);
  const std::string text =
      document(R"({"name": "a", "sphere": {"center": [1e300, 0, 0], "radius": 1}})");
  EXPECT_THROW((void)placed_document(text, "d.json", scaling(1e10)), Error);
}

using PlaceJsonOfFiles = test::ScratchDirectory;

TEST_F(PlaceJsonOfFiles, refuses_documents_that_avoid_a_file) {
  write_mesh(path("crate.off"), test::box({-3, -4, -4}, {3, 4, 4}));
  const std::string text = document(R"(
    {"name": "a", "pipe": {"from": [-30, 0, 0], "to": [-20, 0, 0], "radius": 1}},
    {"name": "b", "pipe": {"from": [20, 0, 0], "to": [30, 0, 0], "radius": 1}},
    {"name": "c", "cyclic_blend": {"from": "a.end", "to": "b.start", "k": "auto", "l": "auto",
      "avoid": [{"mesh": "crate.off"}], "clearance": 2}})");
  try {
    (void)placed_document(text, path("plant.json").string(), turning(90));
    FAIL() << "a file would stay where it is";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("part 'c' avoids the mesh 'crate.off'"));
  }
}

}  // namespace
}  // namespace dupin
