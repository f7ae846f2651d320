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

TEST(PartBox, of_nothing_known_is_infinite) {
  EXPECT_EQ(part_box(Chain()).min(), Vec3(Vec3::Constant(-HUGE_VAL)));
}

}  // namespace
}  // namespace dupin::assembly
