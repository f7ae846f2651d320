#include <functional>
#include <map>
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
  return formats::read_3mf_model("root", [&](const std::string&) {
    return formats::ModelText{std::string(xml), std::string(place)};
  });
}

/// A package of these parts.
TriMesh read_parts(const std::map<std::string, std::string>& parts) {
  return formats::read_3mf_model("root", [&](const std::string& name) {
    if (!parts.contains(name)) {
      throw Error(Errc::parse_failed, "no such part", {}, name);
    }
    return formats::ModelText{parts.at(name), name};
  });
}

std::string message_of(const std::function<TriMesh()>& read) {
  try {
    (void)read();
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

/// A model of these resources and build items.
std::string model(const std::string& resources, const std::string& build) {
  return "<?xml version=\"1.0\"?>\n<model xmlns=\"m\" xmlns:p=\"http://schemas.microsoft.com/"
         "3dmanufacturing/production/2015/06\"><resources>" +
         resources + "</resources>\n<build>" + build + "</build></model>";
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

TEST(ThreeMf, numbers_may_have_space_around_them) {
  std::string mesh = kMesh;
  mesh.replace(mesh.find("x=\"1\""), 5, "x=\" \n+2.0\t\"");
  mesh.replace(mesh.find("v2=\"1\""), 6, "v2=\" 1 \"");
  EXPECT_EQ(
      read_model(model("<object id=\" 1\">" + mesh, "<item objectid=\"1 \"/>"), "m").points[1],
      Vec3(2, 0, 0));
  mesh.replace(mesh.find("+2.0"), 4, "2 0 ");
  EXPECT_THROW((void)read_model(model("<object id=\"1\">" + mesh, "<item objectid=\"1\"/>"), "m"),
               Error);
}

TEST(ThreeMf, objects_without_a_name_are_called_by_their_material) {
  const std::string materials =
      "<basematerials id=\"5\"><base name=\"red\" displaycolor=\"#FF0000\"/>"
      "<base name=\"blue\" displaycolor=\"#0000FF\"/></basematerials>";
  const auto names = [&](const std::string& object, const std::string& mesh = kMesh) {
    return read_model(model(materials + "<object id=\"1\" " + object + ">" + mesh,
                            "<item objectid=\"1\"/>"),
                      "m")
        .names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("pid=\"5\" pindex=\"1\""), Names{"blue"});
  EXPECT_EQ(names("name=\"box\" pid=\"5\" pindex=\"1\""), Names{"box"});
  EXPECT_EQ(names("pid=\"5\""), Names{});
  std::string own = kMesh;
  own.replace(own.find("v3=\"2\""), 6, "v3=\"2\" p1=\"0\"");
  EXPECT_EQ(names("pid=\"5\" pindex=\"1\"", own), Names{"red"});
  EXPECT_EQ(message_of([&] {
              return read_model(
                  model(materials + "<object id=\"1\" pid=\"5\" pindex=\"2\">" + kMesh,
                        "<item objectid=\"1\"/>"),
                  "m");
            }).find("found 2 as 'pindex'") == std::string::npos,
            false);
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
          {"<model unit=\"parsec\"/>",
           "m:1: found the unit 'parsec', expected micron, millimeter, centimeter, inch, foot or "
           "meter"},
          {"<model unit=\"\"/>",
           "m:1: found the unit '', expected micron, millimeter, centimeter, inch, foot or meter"},
          {object(vertex + "<b:beamlattice xmlns:b=\"urn:lattice\"/>"),
           "m:2: found the element 'beamlattice', whose shape is not read, expected triangles and "
           "components"},
          {model("<object id=\"1\"><booleanshape objectid=\"2\"/></object>", ""),
           "m:2: found the element 'booleanshape', whose shape is not read, expected triangles and "
           "components"},
          {"<model/>garbage",
           "m:1: found faulty XML (junk after document element), expected valid XML"},
          {object("<vertex x=\"0\" y=\"0\"/>"), "m:2: found no attribute 'z', expected one"},
          {object("<vertex x=\"nan\" y=\"0\" z=\"0\"/>"),
           "m:2: found 'nan' as 'x', expected a finite number"},
          {object("<vertex x=\"1e999\" y=\"0\" z=\"0\"/>"),
           "m:2: found '1e999' as 'x', expected a number in the range of doubles"},
          {object("<vertex x=\"1e-999\" y=\"0\" z=\"0\"/>"),
           "m:2: found '1e-999' as 'x', expected a number in the range of doubles"},
          {object("<vertex x=\"0 0\" y=\"0\" z=\"0\"/>"),
           "m:2: found '0 0' as 'x', expected a finite number"},
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

constexpr char kCore[] = "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
constexpr char kSlice[] = "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\"";

std::string shown(const std::string& attributes, const std::string& resources) {
  return "<model " + std::string(kCore) + " " + attributes + "><resources>" + resources +
         "</resources><build><item objectid=\"1\"/></build></model>";
}

// Slices have vertices of their own, without a height.
TEST(ThreeMf, elements_of_extensions_are_not_taken_for_those_of_the_core) {
  const std::string slices =
      "<s:slicestack id=\"9\"><s:slice ztop=\"1\"><s:vertices><s:vertex x=\"7\" "
      "y=\"7\"/></s:vertices>"
      "<s:polygon startv=\"0\"/></s:slice></s:slicestack><s:build/><s:model/><s:object/>";
  const TriMesh mesh =
      read_model(shown(kSlice, slices + "<object id=\"1\" s:slicestackid=\"9\">" + kMesh), "m");
  EXPECT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

TEST(ThreeMf, what_is_not_the_shape_of_an_object_is_refused) {
  const std::string object = "<object id=\"1\">" + kMesh;
  const std::string declared = std::string(kSlice) + " xmlns:v=\"urn:volumes\"";
  EXPECT_EQ(read_model(shown(declared + " requiredextensions=\" s \"", object), "m").points.size(),
            3U);
  const std::string others =
      ", expected those of production, materials, slices, beam lattices and sets of triangles only";
  test::expect_refused(
      read_model, "m",
      {{shown(declared + " requiredextensions=\"s v\"", object),
        "m:1: found 'urn:volumes' among the required extensions" + others},
       {shown(declared + " requiredextensions=\"w\"", object),
        "m:1: found 'w' among the required extensions" + others},
       {shown(kSlice, "<object id=\"1\" s:meshresolution=\"lowres\">" + kMesh),
        "m:1: found a mesh of low resolution beside slices, which are not read, expected one of "
        "full resolution"}});
}

TEST(ThreeMf, there_is_one_model_and_one_build_and_objects_are_beside_each_other) {
  const std::string object = "<object id=\"1\">" + kMesh, item = "<item objectid=\"1\"/>";
  test::expect_refused(read_model, "m",
                       {{model(object, item + "</build><build>" + item),
                         "m:3: found a second element 'build', expected one"},
                        {model(object + "<model unit=\"inch\"/>", item),
                         "m:2: found a second element 'model', expected one"},
                        {model("<object id=\"2\">" + object + "</object>", item),
                         "m:2: found an object inside of an object, expected it beside that"}});
}

TEST(ThreeMf, a_model_that_shows_nothing_is_refused) {
  const std::string object = "<object id=\"1\">" + kMesh;
  const std::string points =
      "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
      "z=\"0\"/></vertices></mesh></object>";
  const std::string nothing = "<object id=\"1\"><mesh><vertices/><triangles/></mesh></object>";
  const std::string item = "<item objectid=\"1\"/>";
  const std::string none = "found a build of objects without triangles, expected some";
  const std::string parent =
      "<object id=\"2\"><components><component objectid=\"1\"/></components></object>";
  test::expect_refused(
      read_model, "m",
      {{model(object, ""), "m:3: found a build without items, expected what it is to show"},
       {model("", ""), "m:3: found a build without items, expected what it is to show"},
       {"<model><resources>" + object + "</resources>\n<build/></model>",
        "m:2: found a build without items, expected what it is to show"},
       {"<model><resources>" + object + "</resources></model>",
        "m: found no build, expected one with items"},
       {"<model/>", "m: found no build, expected one with items"},
       {model("<object id=\"1\"/>", item), "m: " + none},
       {model(points, item), "m: " + none},
       {model(nothing, item), "m: " + none},
       {model(nothing + parent, "<item objectid=\"2\"/>"), "m: " + none},
       {model("<object id=\"1\" name=\"empty set\"/>" + parent, "<item objectid=\"2\"/>"),
        "m: " + none}});
  EXPECT_TRUE(
      read_model(model("<object id=\"1\" name=\"empty set\"/>", item), "m").triangles.empty());
  EXPECT_EQ(
      read_model(model(points + "<object id=\"2\">" + kMesh, item + "<item objectid=\"2\"/>"), "m")
          .triangles.size(),
      1U)
      << "one object with triangles is enough";
}

TEST(ThreeMf, objects_of_other_parts_are_shown_where_items_and_components_put_them) {
  const std::string part = model("<object id=\"1\" name=\"in a part\" p:UUID=\"u\">" + kMesh, "");
  const TriMesh mesh = read_parts(
      {{"root", model("<object id=\"1\" name=\"own\">" + kMesh +
                          "<object id=\"5\"><components><component objectid=\"1\" "
                          "p:path=\"/3D/Objects/A.model\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>"
                          "<component objectid=\"1\"/></components></object>",
                      "<item objectid=\"5\" p:UUID=\"v\" transform=\"2 0 0 0 2 0 0 0 2 0 0 7\"/>"
                      "<item objectid=\"1\" p:path=\"/3D/Objects/a.MODEL\"/>"
                      "<item objectid=\"1\" p:path=\"/root\"/>")},
       {"3D/Objects/A.model", part},
       {"3D/Objects/a.MODEL", "<never-read/>"}});
  EXPECT_EQ(mesh.triangles.size(), 4U);
  ASSERT_EQ(mesh.points.size(), 12U);
  EXPECT_EQ(mesh.points[1], Vec3(22, 0, 7));
  EXPECT_EQ(mesh.points[4], Vec3(2, 0, 7));
  EXPECT_EQ(mesh.points[7], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"own", "in a part"}));
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{1, 0, 1, 0}));
}

TEST(ThreeMf, a_part_may_name_another_and_its_own_build_shows_nothing) {
  const auto component = [](const std::string& path) {
    return "<object id=\"1\"><components><component objectid=\"1\" p:path=\"" + path +
           "\" transform=\"1 0 0 0 1 0 0 0 1 1 0 0\"/></components></object>";
  };
  const TriMesh mesh =
      read_parts({{"root", model(component("/a"), "<item objectid=\"1\"/>")},
                  {"a", model(component("/b"), "<item objectid=\"1\"/>")},
                  {"b", model("<object id=\"1\">" + kMesh, "<item objectid=\"77\"/>")}});
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.points[0], Vec3(2, 0, 0));
}

TEST(ThreeMf, faults_of_other_parts_are_refused_with_their_place) {
  const auto root = [](const std::string& path, const std::string& id = "1") {
    return model("<object id=\"1\">" + kMesh,
                 "<item objectid=\"" + id + "\" p:path=\"" + path + "\"/>");
  };
  const auto message = [](const std::string& of_root, const std::string& of_part) {
    return message_of([&] { return read_parts({{"root", of_root}, {"a", of_part}}); });
  };
  const std::string part = model("<object id=\"1\">" + kMesh, "");
  EXPECT_EQ(message(root("/a"), part), "read");
  EXPECT_EQ(message(root("a"), part),
            "root:3: found 'a' as path, expected a part, such as '/3D/part.model'");
  EXPECT_EQ(message(root("/b"), part), "b: no such part");
  EXPECT_EQ(message(root("/a", "2"), part),
            "root:3: found object 2, expected the id of an object of the part '/a'");
  EXPECT_EQ(message(root("/a"), "<model>\n<object/></model>"),
            "a:2: found no attribute 'id', expected one");
  EXPECT_EQ(message(root("/a"), "<xml/>"), "a: found no element 'model', expected one");
  EXPECT_EQ(message(root("/a"), "<model unit=\"inch\"/>"),
            "a:1: found the unit 'inch', expected that of the root, 'millimeter'");
  const std::string back = model(
      "<object id=\"2\"><components><component objectid=\"1\" "
      "p:path=\"/root\"/></components></object>",
      "");
  EXPECT_EQ(message(root("/a", "2"), back),
            "a:2: found the part '/root' inside of itself, expected no circle");
}

TEST(ThreeMf, parts_that_name_each_other_without_end_are_refused) {
  std::map<std::string, std::string> parts;
  const auto name = [](int i) { return i == 0 ? "root" : "p" + std::to_string(i); };
  for (int i = 0; i < 300; ++i) {
    parts[name(i)] = model("<object id=\"1\"><components><component objectid=\"1\" p:path=\"/" +
                               name(i + 1) + "\"/></components></object>",
                           "<item objectid=\"1\"/>");
  }
  EXPECT_EQ(message_of([&] { return read_parts(parts); }),
            "p99:2: parts name parts more than 100 levels deep");
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
