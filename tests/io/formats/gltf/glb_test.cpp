#include "dupin/io/glb.h"

#include <gtest/gtest.h>

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
}

TEST(Glb, is_recognised_by_its_first_bytes) {
  EXPECT_EQ(kGlb.recognises(glb_bytes({})), Evidence::signature);
  EXPECT_EQ(kGlb.recognises("glT"), Evidence::none);
  EXPECT_EQ(kGlb.recognises(""), Evidence::none);
  EXPECT_EQ(kGlb.unit(glb_bytes(test::tetrahedron(), {"ft", ""}), "x"), "ft");
}

}  // namespace
}  // namespace dupin
