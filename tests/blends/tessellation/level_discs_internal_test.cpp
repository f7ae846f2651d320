#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tessellation/level_discs.h"

namespace dupin::tessellation {
namespace {

SampledRing ring(double radius, std::uint32_t segments, double phase, const Vec3& normal) {
  return {
      {Vec3(249986.7654, 114190.6789, 12392.2065), normal, radius}, {segments, phase, 0x1p-12}, {}};
}

const Vec3 kNormal = Vec3(0.3, -0.5, 0.7).normalized();

using Corners = std::array<std::array<double, 3>, 3>;

// Triangles by their corners, in any order; with `reversed`, turned over.
std::set<Corners> corners(const TriMesh& mesh, bool reversed) {
  std::set<Corners> result;
  for (auto [a, b, c] : mesh.triangles) {
    if (reversed) {
      std::swap(b, c);
    }
    Corners of{};
    for (std::size_t k = 0; const std::uint32_t v : {a, b, c}) {
      const Vec3& p = mesh.points[v];
      of.at(k++) = {p.x(), p.y(), p.z()};
    }
    std::ranges::rotate(of, std::ranges::min_element(of));
    result.insert(of);
  }
  return result;
}

double area(const TriMesh& mesh, const Vec3& normal) {
  double result = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 twice = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    EXPECT_GT(twice.dot(normal), 0);
    result += twice.dot(normal) / 2;
  }
  return result;
}

double polygon_area(double radius, std::uint32_t n) {
  return n * radius * radius * std::sin(2 * std::numbers::pi / n) / 2;
}

TEST(LevelDiscs, annulus_lies_between_both_polygons) {
  TriMesh mesh;
  append_annulus(mesh, ring(57, 31, 0.2, kNormal), ring(110, 44, 0.7, kNormal));
  EXPECT_EQ(mesh.triangles.size(), 31U + 44U);
  EXPECT_NEAR(area(mesh, kNormal), polygon_area(110, 44) - polygon_area(57, 31), 0.2);
}

TEST(LevelDiscs, annulus_of_flipped_rings_is_the_same_seen_from_behind) {
  TriMesh front, back;
  append_annulus(front, ring(57, 31, 0.2, kNormal), ring(110, 44, 0.7, kNormal));
  append_annulus(back, ring(57, 31, 0.2, -kNormal), ring(110, 44, 0.7, -kNormal));
  EXPECT_EQ(corners(front, false), corners(back, true));
  (void)area(back, -kNormal);
}

TEST(LevelDiscs, nested_rings_are_those_that_fit) {
  const SampledRing disc = ring(110, 8, 0, kNormal);
  // The side of an octagon is 8 % nearer than its corners.
  const std::array within{ring(20, 12, 0, -kNormal), ring(57, 12, 0, kNormal),
                          ring(105, 12, 0, kNormal)};
  const std::vector<SampledRing> rings = nested_rings(disc, within);
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_EQ(rings[0].ring.radius, 110);
  EXPECT_EQ(rings[1].ring.radius, 57);
  EXPECT_EQ(rings[2].ring.radius, 20);
  EXPECT_EQ(rings[2].ring.normal, kNormal);
  EXPECT_EQ(nested_rings(disc, {}).size(), 1U);
}

}  // namespace
}  // namespace dupin::tessellation
