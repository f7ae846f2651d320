#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "io/formats/glb_parts.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

using Json = nlohmann::json;

TEST(Glb, chunks_are_aligned_and_lengths_are_true) {
  for (const char* const note : {"", "1", "12", "123"}) {
    const std::string glb = glb_bytes(test::tetrahedron(), {"", note});
    EXPECT_EQ(test::number_at(glb, 8), glb.size());
    EXPECT_EQ(test::number_at(glb, 12) % 4, 0U);
    const std::size_t second = 20 + test::number_at(glb, 12);
    EXPECT_EQ(second + 8 + test::number_at(glb, second), glb.size());
    EXPECT_EQ(test::glb_json(glb)["buffers"][0]["byteLength"], test::number_at(glb, second));
  }
}

TEST(Glb, the_node_scales_to_metres_and_the_accessor_tells_its_bounds) {
  TriMesh mesh = test::tetrahedron();
  mesh.points[0] = Vec3(-0.1, 0, 0);
  const Json json = test::glb_json(glb_bytes(mesh, {"in", ""}));
  EXPECT_EQ(json["nodes"][0]["scale"], Json({0.0254, 0.0254, 0.0254}));
  EXPECT_EQ(json["accessors"][0]["min"], Json({static_cast<double>(-0.1F), 0, 0}));
  EXPECT_EQ(json["accessors"][0]["max"], Json({1, 1, 1}));
  EXPECT_FALSE(test::glb_json(glb_bytes(mesh))["nodes"][0].contains("scale"));
}

TEST(Glb, an_unknown_unit_is_refused) {
  try {
    (void)glb_bytes(test::tetrahedron(), {"ell", ""});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "glTF cannot scale from the unit 'ell' to metres; known are um, mm, cm, m, in and ft");
  }
}

}  // namespace
}  // namespace dupin
