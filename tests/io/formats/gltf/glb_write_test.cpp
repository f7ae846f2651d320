#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "io/formats/creased.h"
#include "io/formats/gltf/glb_parts.h"
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

TEST(Glb, colours_come_back_as_they_were_chosen) {
  // What a viewer shows of a linear share.
  const auto shown = [](double linear) {
    return std::lround(
        255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055));
  };
  TriMesh mesh = test::tetrahedron();
  mesh.names = {"a"};
  mesh.labels.assign(mesh.triangles.size(), 0);
  for (int channel = 0; channel < 256; ++channel) {
    std::array<char, 8> code{};
    (void)std::snprintf(code.data(), code.size(), "#%02x80ff", unsigned(channel));
    MeshHeader header{"mm", ""};
    header.colours = {{"a", code.data()}};
    const Json json = test::glb_json(glb_bytes(mesh, header));
    const Json& colour = json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
    EXPECT_EQ(shown(colour[0]), channel);
    EXPECT_EQ(shown(colour[1]), 0x80);
    EXPECT_EQ(colour[2], 1);
  }
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

TEST(Glb, points_with_several_normals_are_written_as_copies_and_read_as_one) {
  MeshHeader header{"mm", ""};
  header.normals = test::creased_normals();
  const TriMesh mesh = test::labelled_tetrahedron();
  const std::string glb = glb_bytes(mesh, header);
  const Json json = test::glb_json(glb);
  const std::size_t body = 20 + test::number_at(glb, 12) + 8;
  const auto at = [&](std::size_t accessor, std::size_t number) {
    const Json& view = json["bufferViews"][accessor];  // one for each accessor
    return test::number_at(glb, body + view["byteOffset"].get<std::size_t>() + 4 * number);
  };
  EXPECT_EQ(json["accessors"][0]["count"], 4 + test::kCreasedCopies);
  EXPECT_EQ(json["accessors"][1]["count"], 4 + test::kCreasedCopies);
  for (const Json& of_part : json["meshes"]) {
    EXPECT_EQ(of_part["primitives"][0]["attributes"], Json({{"POSITION", 0}, {"NORMAL", 1}}));
  }
  ASSERT_EQ(json["asset"]["extras"]["copies"], 2);
  for (std::size_t i = 0; i < test::kCreasedCopies; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(at(0, 3 * (4 + i) + axis), at(0, 3 * at(2, i) + axis)) << i;
    }
  }
  EXPECT_TRUE(test::identical(read_glb(glb, "x.glb"), mesh));
  TriMesh plain = mesh;
  plain.labels.clear();
  plain.names.clear();
  EXPECT_TRUE(test::identical(read_glb(glb_bytes(plain, header), "x.glb"), plain));
}

TEST(Glb, copies_that_are_none_are_refused) {
  MeshHeader header;
  header.normals = test::creased_normals();
  std::string glb = glb_bytes(test::tetrahedron(), header);
  const Json json = test::glb_json(glb);
  const std::size_t place =
      20 + test::number_at(glb, 12) + 8 + json["bufferViews"][2]["byteOffset"].get<std::size_t>();
  glb[place] = static_cast<char>(glb[place] == 0 ? 1 : 0);
  const std::string expected =
      "x.glb:/asset/extras/copies: found other numbers, expected those of points that the last "
      "ones are copies of";
  const auto refusal = [](const std::string& bytes) -> std::string {
    try {
      (void)read_glb(bytes, "x.glb");
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal(glb).find(expected.substr(6)), std::string::npos) << refusal(glb);
  Json other = json;
  other["asset"]["generator"] = "another";  // whose extras mean something else
  EXPECT_EQ(refusal(test::with_json(glb, other.dump())), "accepted");
}

}  // namespace
}  // namespace dupin
