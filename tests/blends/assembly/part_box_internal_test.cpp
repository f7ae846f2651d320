#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/part_box.h"
#include "dupin/blends/junction.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"

namespace dupin::assembly {
namespace {

// Of the document's only part.
Eigen::AlignedBox3d box_of(const std::string& part) {
  const ResolvedAssembly resolved = resolve(parse_assembly(
      R"({"units": "mm", "tolerance": 0.01, "parts": [)" + part + "]}", "test.json"));
  return part_box(resolved.parts.at(0).shape);
}

void expect_near(const Eigen::AlignedBox3d& box, const Vec3& low, const Vec3& high) {
  EXPECT_TRUE((box.min().array() <= low.array()).all()) << box.min().transpose();
  EXPECT_TRUE((box.max().array() >= high.array()).all()) << box.max().transpose();
  EXPECT_LT((box.min() - low).norm() + (box.max() - high).norm(), 1e-5);
}

TEST(PartBox, of_a_straight_pipe_is_tight) {
  expect_near(
      box_of(R"({"name": "a", "pipe": {"from": [1, 2, 3], "to": [1, 2, 23], "radius": 5}})"),
      {-4, -3, 3}, {6, 7, 23});
}

TEST(PartBox, of_a_sphere_is_tight) {
  expect_near(box_of(R"({"name": "a", "sphere": {"center": [1, 2, 3], "radius": 0.1}})"),
              {.9, 1.9, 2.9}, {1.1, 2.1, 3.1});
}

// Of collars whose circles' planes turn too fast for bounds of them, the spheres tell.
TEST(PartBox, of_arms_is_finite_and_holds_them) {
  for (const double radius : {13.0, 30.0, 200.0}) {
    for (const double slope : {-0.05, 0.0, 0.1}) {
      std::vector<Ring> ends;
      for (const Vec3& to : {Vec3(1, 0.2, 0), Vec3(-0.5, 1, 0.3), Vec3(0.1, -0.4, -1)}) {
        const Vec3 way = to.normalized();
        ends.push_back({(1.3 * radius + 10) * way, -way, 1, slope});
      }
      const JunctionSearch search =
          search_junction(ends, {.center = Vec3(0, 0, 0), .radius = radius});
      ASSERT_TRUE(search.junction) << search.reason;
      for (const JunctionArm& arm : search.junction->arms) {
        const Eigen::AlignedBox3d box = part_box(tube(arm));
        EXPECT_LT(box.diagonal().norm(), 6 * radius + 40);
        for (int i = 0; i <= 64; ++i) {
          const Ring circle = circle_at(arm.collar, i / 64.0);
          const Vec3 across =
              (Vec3::Ones() - Vec3::Ones().cwiseProduct(circle.normal.cwiseAbs2())).cwiseSqrt();
          const Vec3 reach = (circle.radius * (1 - 1e-12)) * across;
          EXPECT_TRUE(box.contains(Vec3(circle.center + reach)));
          EXPECT_TRUE(box.contains(Vec3(circle.center - reach)));
        }
      }
    }
  }
}

// Of pipes side by side along the diagonal of space, whose boxes along the axes of coordinates all
// overlap.
TEST(MainAxes, are_those_of_long_parts_askew) {
  std::string parts;
  const Vec3 along = Vec3::Ones().normalized(), across = Vec3(1, -1, 0).normalized();
  const auto text = [](const Vec3& p) {
    return "[" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) +
           "]";
  };
  for (int i = 0; i < 10; ++i) {
    const Vec3 middle = 3 * i * across;
    parts += std::string(i == 0 ? "" : ",") + R"({"name": "p)" + std::to_string(i) +
             R"(", "pipe": {"radius": 1, "from": )" + text(middle - (100 - i) * along) +
             R"(, "to": )" + text(middle + (100 - i) * along) + "}}";
  }
  const ResolvedAssembly resolved = resolve(parse_assembly(
      R"({"units": "mm", "tolerance": 0.01, "parts": [)" + parts + "]}", "test.json"));
  std::vector<const PartSurface*> shapes;
  for (const ResolvedPart& part : resolved.parts) {
    shapes.push_back(&part.shape);
  }
  const auto axes = main_axes(shapes);
  ASSERT_TRUE(axes);
  EXPECT_NEAR(std::abs(axes->right.dot(along)), 1, 1e-6);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Eigen::AlignedBox3d box = part_box(*shapes[i], *axes);
    EXPECT_NEAR(box.sizes()[0], 200 - 2 * double(i), 1e-3);
    EXPECT_NEAR(box.sizes()[1], 2, 1e-3);
    EXPECT_NEAR(box.sizes()[2], 2, 1e-3);
  }
}

TEST(MainAxes, are_none_where_those_of_coordinates_do) {
  const ResolvedAssembly resolved = resolve(parse_assembly(
      R"({"units": "mm", "tolerance": 0.01, "parts": [
          {"name": "a", "pipe": {"from": [0, 0, 0], "to": [100, 0, 0], "radius": 1}},
          {"name": "b", "sphere": {"center": [0, 50, 0], "radius": 5}}]})",
      "test.json"));
  const PartSurface nothing = Chain();
  EXPECT_FALSE(main_axes(
      std::vector<const PartSurface*>{&resolved.parts[0].shape, &resolved.parts[1].shape}));
  EXPECT_FALSE(main_axes(std::vector<const PartSurface*>{&resolved.parts[1].shape}));
  EXPECT_FALSE(main_axes(std::vector<const PartSurface*>{&nothing}));
  EXPECT_FALSE(main_axes({}));
}

TEST(PartBox, of_nothing_known_is_infinite) {
  EXPECT_EQ(part_box(Chain()).min(), Vec3(Vec3::Constant(-HUGE_VAL)));
}

}  // namespace
}  // namespace dupin::assembly
