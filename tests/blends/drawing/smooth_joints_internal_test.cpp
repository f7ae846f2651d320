#include <gtest/gtest.h>

#include "drawing/smooth_joints.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin::drawing {
namespace {

std::set<NamePair> joints(const std::string& parts, double angle = 1e-3) {
  return smooth_joints(
      resolve(parse_assembly(R"({"units": "mm", "tolerance": 0.01, "parts": [)" + parts + "]}",
                             "test")),
      angle);
}

const std::string kPipe =
    R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 2}}, )";

TEST(SmoothJoints, are_those_of_elbows_and_no_cones) {
  EXPECT_EQ(joints(kPipe + R"({"name": "a", "elbow": {"from": "p.end", "bend_radius": 5, "angle":
      90, "toward": [1, 0, 0]}})"),
            (std::set<NamePair>{{"a", "p"}}));
  const std::string cone = kPipe + R"({"name": "c", "cone": {"from": "p.end", "length": 10,
      "end_radius": 3}})";
  EXPECT_TRUE(joints(cone).empty());
  EXPECT_EQ(joints(cone, 0.0996).size(), 0);  // atan 0.1 = 0.09967
  EXPECT_EQ(joints(cone, 0.0997).size(), 1);
}

TEST(SmoothJoints, are_those_of_fillets_and_hubs) {
  const auto example = [](const std::string& name) {
    return smooth_joints(
        resolve(read_assembly(test::source_folder() / "examples" / (name + ".json"))), 1e-3);
  };
  EXPECT_GE(example("tee").size(), 2);
  EXPECT_GE(example("junction").size(), 3);
  EXPECT_EQ(example("oval-duct").size(), 5);  // all there are, rings of ellipses among them
}

}  // namespace
}  // namespace dupin::drawing
