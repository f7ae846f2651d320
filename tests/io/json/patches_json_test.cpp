#include "dupin/io/patches_json.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using nlohmann::json;

json listed(const TriMesh& mesh, const RoundingOptions& options = {},
            const MeshHeader& header = {"mm", {}}) {
  return json::parse(
      patches_json(to_mesh(Solid::from(mesh), Coordinates::binary64, options), "out.stl", header));
}

TEST(PatchesJson, tells_sides_and_a_point_inside) {
  TriMesh box = test::labelled(test::box({0, 0, 0}, {2, 4, 8}), "wall");
  box.names.emplace_back("inlet");
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    const auto& [a, b, c] = box.triangles[i];
    if (box.points[a].z() + box.points[b].z() + box.points[c].z() == 0) {
      box.labels[i] = 1;
    }
  }
  const json parsed = listed(box);
  EXPECT_EQ(parsed.at("file"), "out.stl");
  EXPECT_EQ(parsed.at("unit"), "mm");
  EXPECT_EQ(parsed.at("area"), 2 * (8 + 16 + 32));
  EXPECT_EQ(parsed.at("patches").at(1),
            json::parse(R"({"name": "inlet", "triangles": 2, "area": 8.0, "centroid": [1, 2, 0],
      "vector_area": [0, 0, -8], "normal": [0, 0, -1]})"));
  const json& component = parsed.at("components").at(0);
  EXPECT_GT(component.at("clearance"), 0.5);
  EXPECT_GT(component.at("inside").at(2), 0);
  EXPECT_LT(component.at("inside").at(2), 8);
}

TEST(PatchesJson, has_the_coordinates_of_the_file) {
  RoundingOptions options;
  options.origin = {Origin::Choice::given, {1000, 0, 0}};
  const json parsed = listed(test::box({1000, 0, 0}, {1002, 2, 2}), options);
  EXPECT_EQ(parsed.at("origin"), json({1000, 0, 0}));
  EXPECT_EQ(parsed.at("patches").at(0).at("centroid"), json({1, 1, 1}));
  EXPECT_LT(parsed.at("components").at(0).at("inside").at(0), 2);
}

TEST(PatchesJson, says_null_for_what_is_not_there) {
  const json parsed = listed(test::box({0x1p30, 0, 0}, {0x1p30 + 0x1p-22, 1, 1}), {}, {});
  EXPECT_EQ(parsed.at("unit"), nullptr);
  EXPECT_EQ(parsed.at("components").at(0), json({{"inside", nullptr}, {"clearance", nullptr}}));
  EXPECT_EQ(parsed.at("patches").at(0).at("normal"), nullptr);  // a closed surface has none
}

// What rounding makes of zero has no direction, wherever it is and whatever the numbers of the
// file.
TEST(PatchesJson, has_no_normal_of_tubes_and_closed_surfaces) {
  const auto sides = [](const Vec3& axis, const Vec3& at, double end, Coordinates coordinates) {
    TriMesh tube = test::tube(1, 0, 3, 37);
    for (const auto& [a, b, c] : tube.triangles) {
      const double z = tube.points[a].z() + tube.points[b].z() + tube.points[c].z();
      tube.labels.push_back(z == 0 ? 1 : z == 9 ? 2 : 0);
    }
    tube.names = {"side", "bottom", "top"};
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis);
    for (Vec3& point : tube.points) {
      const double size = point.z() == 3 ? end : 1;
      point = at + turn * Vec3(size * point.x(), size * point.y(), point.z());
    }
    RoundingOptions options;
    options.tolerance = 0.01;
    const json listed = json::parse(
        patches_json(to_mesh(Solid::from(tube), coordinates, options), "out.stl", {"mm", {}}));
    return listed.at("patches");
  };
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1234.5, -77, 3e3)}) {
    for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
      const json straight = sides(axis, at, 1, coordinates);
      ASSERT_EQ(straight.size(), 3U);
      EXPECT_TRUE(straight[0].at("normal").is_null()) << straight[0];
      EXPECT_NEAR(straight[2].at("normal")[2], axis.z(), 1e-3);
      // A little wider at one end.
      const json conical = sides(axis, at, 1.01, coordinates);
      ASSERT_FALSE(conical[0].at("normal").is_null()) << conical[0];
      EXPECT_NEAR(conical[0].at("normal")[2], -axis.z(), 0.1);
    }
  }
}

}  // namespace
}  // namespace dupin
