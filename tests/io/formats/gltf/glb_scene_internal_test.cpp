#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/glb.h"
#include "formats/gltf/glb_scene.h"
#include "io/formats/gltf/glb_parts.h"
#include "support/sample_meshes.h"

namespace dupin::formats {
namespace {

std::vector<MeshInstance> shown(const std::string& json) {
  const std::string glb = test::with_json(glb_bytes(test::tetrahedron()), json);
  return shown_meshes(GlbDocument(glb, "x"));
}

TEST(GlbScene, nodes_are_walked_in_the_order_of_the_file) {
  const auto meshes = shown(
      R"({"meshes": [{"name": "m"}, {}], "scenes": [{"nodes": [3, 0]}],
          "nodes": [{"mesh": 1, "name": "d"}, {"mesh": 0, "name": "b"}, {"mesh": 0},
                    {"mesh": 0, "name": "a", "children": [1, 2]}]})");
  std::vector<std::string> names;
  for (const MeshInstance& instance : meshes) {
    names.push_back(instance.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "m", "d"}));
  EXPECT_EQ(meshes.back().mesh, 1U);
}

TEST(GlbScene, a_nodes_place_is_that_of_its_parents_after_scale_turn_and_shift) {
  const auto meshes = shown(
      R"({"meshes": [{}], "nodes": [
          {"translation": [0, 0, 1], "rotation": [0, 1, 0, 0], "children": [1]},
          {"mesh": 0, "translation": [1, 2, 3], "rotation": [0, 0, 0.5, 0.8660254037844386],
           "scale": [2, 3, 4]}]})");
  ASSERT_EQ(meshes.size(), 1U);
  const Transform& place = meshes[0].transform;
  // 60 degrees about z after the scale, then half a turn about y.
  const Vec3 moved = place.linear * Vec3(1, 0, 0) + place.shift;
  EXPECT_NEAR(moved.x(), -(1 + 2 * 0.5), 1e-14);
  EXPECT_NEAR(moved.y(), 2 + 2 * 0.8660254037844386, 1e-14);
  EXPECT_NEAR(moved.z(), -3 + 1, 1e-14);
}

TEST(GlbScene, small_turns_are_not_taken_for_none) {
  const auto angle = [](double radians) {
    return shown(R"({"meshes": [{}], "nodes": [{"mesh": 0, "rotation": [0, 0, )" +
                 std::to_string(radians / 2) + ", 1]}]}")[0]
        .transform.linear(1, 0);
  };
  EXPECT_NEAR(angle(0.00001), 0.00001, 1e-12);
  EXPECT_EQ(angle(0), 0);
}

}  // namespace
}  // namespace dupin::formats
