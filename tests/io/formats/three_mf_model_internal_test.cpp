#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "formats/three_mf_model.h"
#include "support/malformed.h"

namespace dupin {
namespace {

TriMesh read_model(std::string_view xml, std::string_view place) {
  return formats::read_3mf_model(xml, std::string(place));
}

/// A model of these resources and build items.
std::string model(const std::string& resources, const std::string& build) {
  return "<?xml version=\"1.0\"?>\n<model xmlns=\"m\"><resources>" + resources +
         "</resources>\n<build>" + build + "</build></model>";
}

const std::string kMesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
    "</triangles></mesh></object>";

TEST(ThreeMf, items_and_components_are_moved_and_mirrors_keep_the_orientation) {
  const TriMesh mesh = read_model(
      model("<object id=\"1\" name=\"pump\">" + kMesh +
                "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 "
                "0 1 "
                "10 20 30\"/></components></object>",
            "<item objectid=\"1\"/><item objectid=\"2\" transform=\"-1 0 0 0 2 0 0 0 1 0 0 5\"/>"),
      "m");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 5, 4}}));
  EXPECT_EQ(mesh.points[3], Vec3(-10, 40, 35));
  EXPECT_EQ(mesh.points[4], Vec3(-11, 40, 35));
  EXPECT_EQ(mesh.points[5], Vec3(-10, 42, 35));
  EXPECT_EQ(mesh.names, std::vector<std::string>{"pump"});
}

TEST(ThreeMf, a_turning_transform_follows_the_row_vector_convention) {
  // x' = -y, y' = x: the first row says where the x axis goes.
  const TriMesh mesh =
      read_model(model("<object id=\"1\">" + kMesh,
                       "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/>"),
                 "m");
  EXPECT_EQ(mesh.points[1], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.points[2], Vec3(-1, 0, 0));
}

TEST(ThreeMf, malformed_models_are_refused_with_their_line) {
  const auto object = [](const std::string& inside) {
    return model("<object id=\"1\"><mesh>" + inside + "</mesh></object>", "");
  };
  const std::string vertex = "<vertex x=\"0\" y=\"0\" z=\"0\"/>";
  test::expect_refused(
      read_model, "m",
      {
          {"", "m:1: found faulty XML (no element found), expected valid XML"},
          {"<a/>", "m: found no element 'model', expected one"},
          {"<model>\n<b></model>", "m:2: found faulty XML (mismatched tag), expected valid XML"},
          {"<!DOCTYPE model>\n<model/>", "m:1: found a document type declaration, expected none"},
          {"<model name=\"\xff\"/>",
           "m:1: found faulty XML (not well-formed (invalid token)), expected valid XML"},
          {"<model/>garbage",
           "m:1: found faulty XML (junk after document element), expected valid XML"},
          {object("<vertex x=\"0\" y=\"0\"/>"), "m:2: found no attribute 'z', expected one"},
          {object("<vertex x=\"nan\" y=\"0\" z=\"0\"/>"),
           "m:2: found 'nan' as 'x', expected a finite number"},
          {object("<vertex x=\"1e999\" y=\"0\" z=\"0\"/>"),
           "m:2: found '1e999' as 'x', expected a finite number"},
          {object("<vertex x=\"0 \" y=\"0\" z=\"0\"/>"),
           "m:2: found '0 ' as 'x', expected a finite number"},
          {object(vertex + "<triangle v1=\"0\" v2=\"0\"/>"),
           "m:2: found no attribute 'v3', expected one"},
          {object(vertex + "<triangle v1=\"0\" v2=\"0\" v3=\"1\"/>"),
           "m:2: found 1 as 'v3', expected the index of one of the 1 vertices"},
          {object(vertex + "<triangle v1=\"0\" v2=\"-1\" v3=\"0\"/>"),
           "m:2: found '-1' as 'v2', expected an integer of 32 bits"},
          {model(vertex, ""),
           "m:2: found the element 'vertex' outside of an object, expected it inside"},
          {model("<triangle v1=\"0\" v2=\"0\" v3=\"0\"/>", ""),
           "m:2: found the element 'triangle' outside of an object, expected it inside"},
          {model("<object/>", ""), "m:2: found no attribute 'id', expected one"},
          {model("<object id=\"1\"/><object id=\"1\"/>", ""),
           "m:2: found a second object 1, expected a new id"},
          {model("<object id=\"1\"><component objectid=\"1\"/></object>", ""),
           "m:2: found object 1, expected the id of an object before it"},
          {model("<object id=\"1\"/>", "<item objectid=\"2\"/>"),
           "m:3: found object 2, expected the id of an object before it"},
          {model("<object id=\"1\"/>", "<item objectid=\"1\" transform=\"1 0 0\"/>"),
           "m:3: found '' as 'transform', expected a finite number"},
          {model("<object id=\"1\"/>",
                 "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 0\"/>"),
           "m:3: found '1 0 0 0 1 0 0 0 1 0 0 0 0' as 'transform', expected 12 numbers"},
          {model("<object id=\"1\"><mesh><vertex x=\"1e300\" y=\"0\" z=\"0\"/></mesh></object>",
                 "<item objectid=\"1\" transform=\"1e300 0 0 0 1 0 0 0 1 0 0 0\"/>"),
           "m: found a transformation of object 1 beyond the range of doubles, expected finite "
           "coordinates"},
          {model(
               "<basematerials id=\"5\"><base name=\"a\"/></basematerials><object id=\"1\"><mesh>" +
                   vertex +
                   "<triangle v1=\"0\" v2=\"0\" v3=\"0\" pid=\"5\" p1=\"1\"/></mesh></object>",
               ""),
           "m:2: found 1 as 'p1', expected the index of one of the 1 base materials"},
      });
}

TEST(ThreeMf, components_that_unfold_without_measure_are_refused) {
  std::string bomb = "<object id=\"1\">" + kMesh;
  for (int id = 2; id < 40; ++id) {
    const std::string child = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    bomb += "<object id=\"" + std::to_string(id) + "\"><components>";
    bomb += child;
    bomb += child;
    bomb += "</components></object>";
  }
  std::string chain = "<object id=\"1\"/>";
  for (int id = 2; id < 200; ++id) {
    chain += "<object id=\"" + std::to_string(id) + "\"><component objectid=\"" +
             std::to_string(id - 1) + "\"/></object>";
  }
  for (const std::string& resources : {bomb, chain}) {
    try {
      (void)read_model(model(resources, ""), "m");
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
      EXPECT_STREQ(error.what(),
                   "m:2: the components unfold to more than 300000000 points and triangles, or lie "
                   "more than 100 levels deep");
    }
  }
}

}  // namespace
}  // namespace dupin
