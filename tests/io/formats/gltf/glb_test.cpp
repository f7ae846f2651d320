#include "dupin/io/glb.h"

#include <gtest/gtest.h>

#include "io/formats/creased.h"
#include "io/formats/gltf/glb_parts.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

TEST(Glb, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_glb(glb_bytes(mesh), "x.glb"), mesh));
  }
  const TriMesh labelled = test::labelled_tetrahedron();
  EXPECT_TRUE(test::identical(read_glb(glb_bytes(labelled, {"mm", "note"}), "x.glb"), labelled));
  EXPECT_TRUE(test::identical(read_glb(glb_bytes({}), "x.glb"), {}));
}

TEST(Glb, only_what_it_writes_itself_is_read_in_coordinates_of_its_own) {
  const std::string glb = glb_bytes(test::tetrahedron(), {"mm", ""});
  nlohmann::json json = test::glb_json(glb);
  json["asset"]["generator"] = "another";
  const TriMesh mesh = read_glb(test::with_json(glb, json.dump()), "x.glb");
  EXPECT_EQ(mesh.points[1], Vec3(0.001, 0, 0)) << "in metres";
  EXPECT_EQ(mesh.points[2], Vec3(0, 0, -0.001)) << "with y upward";
  EXPECT_EQ(mesh.points[3], Vec3(0, 0.001, 0));
  EXPECT_EQ(unit_of_glb(test::with_json(glb, json.dump()), "x.glb"), "m") << "as glTF has it";
}

// By hand, or by a program that keeps the name of ours.
TEST(Glb, what_was_put_elsewhere_is_read_there_and_in_metres) {
  const std::string glb = glb_bytes(test::tetrahedron(), {"mm", ""});
  const nlohmann::json ours = test::glb_json(glb);
  const auto corner_of = [&](const nlohmann::json& json) {
    const std::string edited = test::with_json(glb, json.dump());
    EXPECT_EQ(unit_of_glb(edited, "x.glb"), "m");
    return read_glb(edited, "x.glb").points[1];
  };
  nlohmann::json json = ours;
  json["nodes"][0]["scale"] = {0.002, 0.002, 0.002};
  EXPECT_EQ(corner_of(json), Vec3(0.002, 0, 0));
  json = ours;
  json["nodes"][0]["translation"] = {5, 0, 0};
  EXPECT_EQ(corner_of(json), Vec3(5.001, 0, 0));
  json = ours;
  json["nodes"][0]["rotation"] = {0, 0, 1, 0};
  EXPECT_EQ(corner_of(json), Vec3(-0.001, 0, 0));
  json = ours;
  json["asset"]["extras"]["unit"] = "in";
  EXPECT_EQ(corner_of(json), Vec3(0.001, 0, 0)) << "the scale is that of mm";
  json = ours;
  json["nodes"].push_back({{"scale", {2, 2, 2}}, {"children", {0}}});
  json["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(corner_of(json), Vec3(0.002, 0, 0));
}

TEST(Glb, parts_that_were_put_elsewhere_together_stay_one_mesh) {
  MeshHeader header{"mm", ""};
  header.normals = test::creased_normals();
  const TriMesh mesh = test::labelled_tetrahedron();
  const std::string glb = glb_bytes(mesh, header);
  nlohmann::json json = test::glb_json(glb);
  json["nodes"][0]["translation"] = {5, 0, 0};
  const TriMesh read = read_glb(test::with_json(glb, json.dump()), "x.glb");
  EXPECT_EQ(read.points.size(), mesh.points.size());
  EXPECT_EQ(read.triangles, mesh.triangles);
  EXPECT_EQ(read.names, mesh.names);
}

TEST(Glb, the_empty_set_has_its_unit) {
  EXPECT_EQ(unit_of_glb(glb_bytes({}, {"mm", ""}), "x.glb"), "mm");
  EXPECT_EQ(unit_of_glb(glb_bytes({}), "x.glb"), "");
}

TEST(Glb, whole_numbers_may_have_points_and_exponents) {
  const std::string glb = glb_bytes(test::tetrahedron());
  nlohmann::json json = test::glb_json(glb);
  json["accessors"][0]["count"] = 4.0;
  json["accessors"][1]["componentType"] = 5125e0;
  EXPECT_TRUE(
      test::identical(read_glb(test::with_json(glb, json.dump()), "x.glb"), test::tetrahedron()));
}

TEST(Glb, is_recognised_by_its_first_bytes) {
  EXPECT_EQ(kGlb.recognises(glb_bytes({})), Evidence::signature);
  EXPECT_EQ(kGlb.recognises("glT"), Evidence::none);
  EXPECT_EQ(kGlb.recognises(""), Evidence::none);
  EXPECT_EQ(kGlb.unit(glb_bytes(test::tetrahedron(), {"ft", ""}), "x"), "ft");
}

}  // namespace
}  // namespace dupin
