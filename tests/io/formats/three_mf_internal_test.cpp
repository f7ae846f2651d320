#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/three_mf.h"
#include "dupin/kernel/error.h"
#include "files/zip_package.h"
#include "formats/three_mf_model.h"
#include "support/malformed.h"
#include "support/mutation.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kModel = "3D/3dmodel.model";

TriMesh read_model(std::string_view xml, std::string_view place) {
  return formats::read_3mf_model(xml, std::string(place));
}

std::string model_xml(const TriMesh& mesh, const MeshHeader& header = {}) {
  return files::unzip(three_mf_bytes(mesh, header), kModel, "x.3mf");
}

TEST(ThreeMf, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_3mf(three_mf_bytes(mesh), "x.3mf"), mesh));
  }
  TriMesh labelled = test::labelled_tetrahedron();
  labelled.names[1] = "<\"R&D\">";
  EXPECT_TRUE(test::identical(read_3mf(three_mf_bytes(labelled), "x.3mf"), labelled));
}

TEST(ThreeMf, the_model_tells_unit_names_and_note) {
  const std::string xml = model_xml(test::labelled_tetrahedron(), {"in", "a < b"});
  for (const std::string part :
       {"<model unit=\"inch\" ", "<metadata name=\"Description\">a &lt; b</metadata>",
        "<base name=\"the blend\" displaycolor=\"#", "<vertex x=\"1\" y=\"0\" z=\"0\"/>",
        "<triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"2\" p1=\"1\"/>"}) {
    EXPECT_NE(xml.find(part), std::string::npos) << part;
  }
}

TEST(ThreeMf, an_unknown_unit_is_refused) {
  try {
    (void)three_mf_bytes(test::tetrahedron(), {"ell", ""});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "3MF has no unit 'ell'; it has um, mm, cm, m, in and ft");
  }
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

TEST(ThreeMf, malformed_packages_are_refused) {
  const std::string good = three_mf_bytes(test::tetrahedron());
  const std::string relationships = "_rels/.rels";
  test::expect_refused(
      read_3mf, "x.3mf",
      {
          {"PK\x03\x04", "x.3mf: found no ZIP archive (Not a zip archive), expected a 3MF package"},
          {good.substr(0, good.size() - 30),
           "x.3mf: found no ZIP archive (Not a zip archive), expected a 3MF package"},
          {files::zip_archive({{"a", "b"}}),
           "x.3mf: found no entry '_rels/.rels' in the ZIP archive, expected one"},
          {files::zip_archive({{relationships, "<a/>"}}),
           "x.3mf:_rels/.rels: found no relationship to a 3D model, expected one"},
          {files::zip_archive({{relationships, files::unzip(good, relationships, "")}}),
           "x.3mf: found no entry '3D/3dmodel.model' in the ZIP archive, expected one"},
          {files::zip_archive(
               {{relationships, files::unzip(good, relationships, "")}, {kModel, "<model>"}}),
           "x.3mf:3D/3dmodel.model:1: found faulty XML (no element found), expected valid XML"},
      });
}

TEST(ThreeMf, a_package_that_expands_without_measure_is_refused) {
  const std::string bomb =
      files::zip_archive({{"_rels/.rels", std::string(std::size_t{65} << 20, ' ')}});
  try {
    (void)read_3mf(bomb, "x.3mf");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
  }
}

TEST(ThreeMf, mutated_models_are_read_or_refused) {
  const std::string good = model_xml(test::labelled_tetrahedron());
  std::mt19937_64 random(20000);
  std::size_t refused = 0;
  for (int i = 0; i < 20000; ++i) {
    try {
      (void)three_mf_bytes(read_model(test::mutated(good, random), "m"));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 2000U);
  EXPECT_LT(refused, 20000U);
}

}  // namespace
}  // namespace dupin
