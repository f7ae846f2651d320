#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "io/formats/gltf/glb_parts.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

using Json = nlohmann::json;

/// A valid file after one change of its JSON.
std::string changed(const std::string& pointer, const Json& value) {
  const std::string glb = glb_bytes(test::tetrahedron());
  Json json = test::glb_json(glb);
  json[Json::json_pointer(pointer)] = value;
  return test::with_json(glb, json.dump());
}

TEST(Glb, malformed_files_are_refused_with_their_place) {
  const std::string glb = glb_bytes(test::tetrahedron());
  const std::size_t body = 20 + test::number_at(glb, 12) + 8;
  std::string version = glb;
  version[4] = '\1';
  std::string chunk = glb;
  chunk[15] = '\x7f';
  std::string nan = glb;
  nan.replace(body + 16, 4, "\xff\xff\xff\xff");
  std::string index = glb;
  index[body + 48 + 8] = '\4';
  const std::string size = std::to_string(glb.size());
  test::expect_refused(
      read_glb, "x.glb",
      {
          {"", "x.glb:byte 0: found no header of binary glTF, expected 'glTF' and 8 more bytes"},
          {std::string("glTF\2\0\0", 7),
           "x.glb:byte 0: found no header of binary glTF, expected 'glTF' and 8 more bytes"},
          {version, "x.glb:byte 4: found version 1, expected 2"},
          {glb + "x", "x.glb:byte 8: found a length of " + size + " in a file of " +
                          std::to_string(glb.size() + 1) + " bytes, expected the same"},
          {chunk, "x.glb:byte 12: found a chunk of " + std::to_string(test::number_at(chunk, 12)) +
                      " bytes, expected at most " + std::to_string(glb.size() - 12)},
          {test::with_json(glb, "{\"asset\":"),
           "x.glb:byte 20: found faulty JSON, expected an object"},
          {test::with_json(glb, "[]"), "x.glb:byte 20: found faulty JSON, expected an object"},
          {changed("/meshes", 7), "x.glb:/meshes/0: found nothing there, expected an entry"},
          {changed("/meshes", Json::array()),
           "x.glb:/meshes/0: found nothing there, expected an entry"},
          {changed("/meshes/0", 7), "x.glb:/meshes/0: found no 'primitives', expected one"},
          {changed("/meshes/0/primitives", 7),
           "x.glb:/meshes/0/primitives: found no array, expected one"},
          {changed("/meshes/0/primitives/0", Json::object()),
           "x.glb:/meshes/0/primitives/0: found no 'attributes', expected one"},
          {changed("/meshes/0/primitives/0/mode", 7),
           "x.glb:/meshes/0/primitives/0/mode: found 7, expected 4, 5 or 6, triangles, strips and "
           "fans of them, or less"},
          {changed("/meshes/0/primitives/0/mode", 3),
           "x.glb:/meshes: found meshes without triangles, expected some"},
          {changed("/accessors/1/componentType", 5126),
           "x.glb:/meshes/0/primitives/0/indices: found floats, expected integers"},
          {changed("/nodes/0/skin", 0),
           "x.glb:/nodes/0/skin: found a skin, whose pose is not read, expected none"},
          {changed("/meshes/0/weights", {0, 0.5}),
           "x.glb:/meshes/0/weights: found weights of other shapes, which are not read, expected "
           "none but 0"},
          {changed("/nodes/0/weights", {1}),
           "x.glb:/nodes/0/weights: found weights of other shapes, which are not read, expected "
           "none but 0"},
          {changed("/nodes/0/extensions", {{"EXT_mesh_gpu_instancing", Json::object()}}),
           "x.glb:/nodes/0/extensions: found instances of a mesh, which are not read, expected a "
           "node for each"},
          {changed("/meshes/0/primitives", Json::array()),
           "x.glb:/meshes: found meshes without triangles, expected some"},
          {changed("/extensionsRequired", Json::array({"KHR_draco_mesh_compression"})),
           "x.glb:/extensionsRequired/0: found 'KHR_draco_mesh_compression', expected no extension "
           "but of materials; decode the file, or export it without compression"},
          {changed("/meshes/0/primitives/0/indices", -1),
           "x.glb:/meshes/0/primitives/0/indices: found -1, expected an integer from 0 to "
           "4294967295"},
          {changed("/meshes/0/primitives/0/indices", 2),
           "x.glb:/accessors/2: found nothing there, expected an entry"},
          {changed("/meshes/0/primitives/0/indices", 0),
           "x.glb:/accessors/0: found another kind of accessor, expected one of SCALAR"},
          {changed("/meshes/0/primitives/0/material", 0),
           "x.glb:: found no 'materials', expected one"},
          {changed("/accessors/0/sparse", 1),
           "x.glb:/accessors/0/sparse: found a sparse accessor, expected a dense one: others are "
           "not read; export it with all values"},
          {changed("/accessors/0/componentType", 5130),
           "x.glb:/accessors/0/componentType: found 5130, expected 5126, floats; convert quantized "
           "points to these"},
          {changed("/accessors/0/componentType", 5122),
           "x.glb:/accessors/0/componentType: found 5122, expected 5126, floats; convert quantized "
           "points to these"},
          {changed("/accessors/1/componentType", 5122),
           "x.glb:/accessors/1/componentType: found 5122, expected 5121, 5123 or 5125"},
          {changed("/accessors/1/componentType", 5126),
           "x.glb:/meshes/0/primitives/0/indices: found floats, expected integers"},
          {changed("/extensionsRequired", Json::array({"EXT_meshopt_compression"})),
           "x.glb:/extensionsRequired/0: found 'EXT_meshopt_compression', expected no extension "
           "but of materials; decode the file, or export it without compression"},
          {changed("/extensionsRequired", Json::array({"KHR_mesh_quantization"})),
           "x.glb:/extensionsRequired/0: found 'KHR_mesh_quantization', expected no extension but "
           "of materials; convert its points to floats, or export it without quantization"},
          {changed("/accessors/0/count", 5),
           "x.glb:/accessors/0: found 5 entries of 12 bytes, 12 apart, expected room for them in a "
           "view of 48 bytes"},
          {changed("/accessors/0/count", 4000000000U),
           "x.glb:/accessors/0: found 4000000000 entries of 12 bytes, 12 apart, expected room for "
           "them in a view of 48 bytes"},
          {changed("/accessors/1/count", 11),
           "x.glb:/meshes/0/primitives/0/indices: found 11 indices, expected three per triangle"},
          {changed("/accessors/1/byteOffset", 4),
           "x.glb:/accessors/1: found 12 entries of 4 bytes, 4 apart, expected room for them in a "
           "view of 48 bytes"},
          {changed("/bufferViews/0/byteStride", 8),
           "x.glb:/accessors/0: found 4 entries of 12 bytes, 8 apart, expected room for them in a "
           "view of 48 bytes"},
          {changed("/bufferViews/0/byteLength", 97),
           "x.glb:/bufferViews/0: found 97 bytes from byte 0, expected room for them in a buffer "
           "of 96 bytes"},
          {changed("/buffers/0/uri", "other.bin"),
           "x.glb:/buffers/0/uri: found a buffer elsewhere, expected the one inside"},
          {changed("/bufferViews/1/buffer", 1),
           "x.glb:/bufferViews/1/buffer: found another buffer, expected 0, the one inside"},
          {nan,
           "x.glb:/meshes/0/primitives/0/attributes/POSITION: found point 1 not finite, expected "
           "finite coordinates"},
          {index, "x.glb:/meshes/0/primitives/0/indices: found index 4 at 2, expected less than 4"},
      });
}

/// Two meshes of one triangle each, the second without indices, under the nodes and scenes given.
std::string scene_of(const Json& more) {
  const std::string glb = glb_bytes(test::tetrahedron());
  Json json = test::glb_json(glb);
  json["asset"]["generator"] = "another";
  json["accessors"][1]["count"] = 3;
  json["meshes"][0] = {{"name", "first"}, {"primitives", json["meshes"][0]["primitives"]}};
  json["meshes"][0]["primitives"][0]["material"] = 0;
  json["accessors"][1]["byteOffset"] = 12;  // the second triangle of the tetrahedron
  json["accessors"][0]["count"] = 4;
  json["materials"] = Json::array({{{"name", "steel"}}});
  json["accessors"].push_back(json["accessors"][0]);
  json["accessors"][2]["count"] = 3;
  json["meshes"].push_back(
      {{"name", "second"}, {"primitives", Json::array({{{"attributes", {{"POSITION", 2}}}}})}});
  json.erase("scene");
  json.erase("scenes");
  json.erase("nodes");
  json.update(more);
  return test::with_json(glb, json.dump());
}

TEST(Glb, nodes_show_meshes_where_they_put_them_as_often_as_they_do) {
  const TriMesh mesh = read_glb(scene_of(Json::parse(R"({
        "scene": 1, "scenes": [{}, {"nodes": [2, 0]}],
        "nodes": [{"mesh": 0, "translation": [10, 0, 0]},
                  {"mesh": 1, "name": "pump", "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 5,0,0,1]},
                  {"children": [1, 3], "rotation": [0, 0, 0.70710678, 0.70710678]},
                  {"mesh": 0, "scale": [1, 1, -1]}]})")),
                                "x.glb");
  // Mesh 1 is (0,0,0), (1,0,0), (0,1,0), as it comes; mesh 0 is triangle 0, 1, 3 of four points.
  ASSERT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 6, 4}, {7, 8, 10}}));
  EXPECT_EQ(mesh.points[0], Vec3(0, 5, 0)) << "a quarter turn is exact";
  EXPECT_EQ(mesh.points[1], Vec3(0, 7, 0));
  EXPECT_EQ(mesh.points[2], Vec3(-2, 5, 0));
  EXPECT_EQ(mesh.points[4], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.points[6], Vec3(0, 0, -1)) << "mirrored, and turned to keep its outside";
  EXPECT_EQ(mesh.points[8], Vec3(11, 0, 0));
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"pump", "steel"}));
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(Glb, without_scenes_all_roots_and_without_nodes_all_meshes_are_shown) {
  const auto triangles = [](const char* more) {
    return read_glb(scene_of(Json::parse(more)), "x.glb").triangles.size();
  };
  EXPECT_EQ(triangles("{}"), 2U);
  EXPECT_EQ(triangles(R"({"nodes": [{"mesh": 0, "children": [1]}, {"mesh": 1}, {"mesh": 1}]})"),
            3U);
  EXPECT_EQ(triangles(R"({"scenes": [{"nodes": [1]}], "nodes": [{"mesh": 0}, {"mesh": 1}]})"), 1U);
}

// With the corners 0, 1, 2, 3 in this order. Triangles that are none turn a strip.
TEST(Glb, strips_and_fans_are_triangles_and_lines_are_no_surface) {
  const auto read = [](int mode, const std::vector<std::uint32_t>& corners) {
    const std::string glb = glb_bytes(test::tetrahedron());
    Json json = test::glb_json(glb);
    json["asset"]["generator"] = "another";
    json["meshes"][0]["primitives"][0]["mode"] = mode;
    json["accessors"][1]["count"] = corners.size();
    json["meshes"][0]["primitives"].push_back({{"mode", 1}, {"attributes", {{"POSITION", 0}}}});
    std::string bytes = glb;
    std::memcpy(&bytes[20 + test::number_at(glb, 12) + 8 + 48], corners.data(), 4 * corners.size());
    return read_glb(test::with_json(bytes, json.dump()), "x.glb").triangles;
  };
  using Triangles = std::vector<Triangle>;
  EXPECT_EQ(read(4, {0, 1, 2, 3, 2, 1}), (Triangles{{0, 1, 2}, {3, 2, 1}}));
  EXPECT_EQ(read(5, {0, 1, 2, 3, 0}), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 0}}));
  EXPECT_EQ(read(5, {0, 1, 2, 2, 3}), (Triangles{{0, 1, 2}})) << "then comes what has 2 twice";
  EXPECT_EQ(read(5, {0, 1, 2, 2, 3, 3, 0, 1}), (Triangles{{0, 1, 2}, {3, 1, 0}}));
  EXPECT_EQ(read(6, {3, 0, 1, 2, 0}), (Triangles{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
}

TEST(Glb, points_without_indices_come_three_by_three) {
  const Json one = Json::parse(R"({"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 1}]})");
  const TriMesh mesh = read_glb(scene_of(one), "x.glb");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.labels.empty()) << "the only mesh needs no name";
  Json json = test::glb_json(scene_of(one));
  json["accessors"][2]["count"] = 4;
  test::expect_refused(read_glb, "x.glb",
                       {{test::with_json(scene_of(one), json.dump()),
                         "x.glb:/meshes/1/primitives/0: found 4 points and no indices, expected "
                         "three per triangle"}});
}

TEST(Glb, scenes_that_show_nothing_or_are_no_forest_are_refused) {
  const auto refused = [](const char* more, const std::string& what) {
    test::expect_refused(read_glb, "x.glb", {{scene_of(Json::parse(more)), "x.glb:" + what}});
  };
  const std::string none = ": found no mesh, expected one that a node shows";
  const std::string twice = ": found a node that is met twice, expected no circle and one parent";
  refused(R"({"scenes": [{}]})", "/scenes/0" + none);
  refused(R"({"scenes": [{"name": "empty"}]})", "/scenes/0" + none);
  refused(R"({"scenes": [{"nodes": []}], "nodes": [{"mesh": 0}]})", "/scenes/0" + none);
  refused(R"({"scenes": [{"nodes": [0]}], "nodes": [{}, {"mesh": 0}]})", "/scenes/0" + none);
  refused(R"({"scene": 2, "scenes": [{"nodes": [0]}]})",
          "/scenes/2: found nothing there, expected an entry");
  refused(R"({"nodes": [{}]})", "/nodes" + none);
  refused(R"({"meshes": []})", "/meshes: found no mesh, expected one");
  refused(R"({"nodes": [{"children": [1]}, {"children": [0], "mesh": 0}]})", "/nodes" + none);
  refused(R"({"scenes": [{"nodes": [0]}],
              "nodes": [{"children": [1]}, {"children": [0], "mesh": 0}]})",
          "/nodes/0" + twice);
  refused(R"({"scenes": [{"nodes": [0]}], "nodes": [{"children": [0], "mesh": 0}]})",
          "/nodes/0" + twice);
  refused(R"({"scenes": [{"nodes": [0, 1]}], "nodes": [{"children": [1]}, {"mesh": 0}]})",
          "/nodes/1" + twice);
  refused(R"({"nodes": [{"children": [7], "mesh": 0}]})",
          "/nodes/7: found nothing there, expected an entry");
  refused(R"({"nodes": [{"children": [-1], "mesh": 0}]})",
          "/nodes/0/children/0: found -1, expected an integer from 0 to 4294967295");
  refused(R"({"nodes": [{"mesh": 2}]})", "/meshes/2: found nothing there, expected an entry");
  refused(R"({"nodes": [{"mesh": 0, "scale": [1, 2]}]})",
          "/nodes/0/scale: found something else, expected 3 finite numbers");
  refused(R"({"nodes": [{"mesh": 0, "rotation": [0, 0, 0, 0]}]})",
          "/nodes/0/rotation: found a quaternion of zeros, expected a turn");
  refused(R"({"nodes": [{"mesh": 0, "matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}]})",
          "/nodes/0/matrix: found a projection, expected 0, 0, 0, 1 in the last row");
  refused(R"({"nodes": [{"mesh": 0, "scale": [1e300, 1, 1], "children": [1]},
                        {"mesh": 0, "scale": [1e300, 1, 1]}]})",
          "/meshes/0: found a transformation beyond the range of doubles, expected finite "
          "coordinates");
}

TEST(Glb, a_chain_of_nodes_may_be_long) {
  Json nodes = Json::array();
  constexpr int kDeep = 100000;
  for (int i = 0; i < kDeep; ++i) {
    nodes.push_back({{"children", {i + 1}}});
  }
  nodes.push_back({{"mesh", 0}});
  EXPECT_EQ(read_glb(scene_of({{"nodes", nodes}}), "x.glb").triangles.size(), 1U);
}

}  // namespace
}  // namespace dupin
