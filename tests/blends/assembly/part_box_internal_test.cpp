#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "assembly/part_box.h"
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

TEST(PartBox, of_nothing_known_is_infinite) {
  EXPECT_EQ(part_box(Chain()).min(), Vec3(Vec3::Constant(-HUGE_VAL)));
}

}  // namespace
}  // namespace dupin::assembly
