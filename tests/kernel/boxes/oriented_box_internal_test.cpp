#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "boxes/oriented_box.h"
#include "boxes/tree_traversal.h"
#include "predicates/triangle_overlap.h"

namespace dupin::boxes {
namespace {

/// A long thin triangle within the unit cube about the origin.
std::array<Vec3, 3> needle(std::mt19937& random, double width) {
  std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
  const auto any = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
  const Vec3 from = any();
  return {from, from + any(), from + width * any()};
}

FramedTriangle framed(const std::array<Vec3, 3>& t) {
  return {t[0].cast<float>(), t[1].cast<float>(), t[2].cast<float>()};
}

Box upright(const std::array<Vec3, 3>& t) {
  Box box = Box::nothing();
  for (const Eigen::Vector3f& p : framed(t)) {
    box.join({{p[0], p[1], p[2]}, {p[0], p[1], p[2]}});
  }
  return box;
}

OrientedBox around(const std::array<Vec3, 3>& t) {
  const FramedTriangle triangle = framed(t);
  return OrientedBox({&triangle, 1});
}

TEST(OrientedBox, is_never_apart_from_what_meets_its_triangle) {
  std::mt19937 random(3);
  int meeting = 0;
  for (int round = 0; round < 40000; ++round) {
    const auto a = needle(random, round % 2 == 0 ? 0.3 : 1e-6), b = needle(random, 0.3);
    const std::array<Vec3, 6> points = {a[0], a[1], a[2], b[0], b[1], b[2]};
    if (predicates::TriangleOverlapTest(points, {0, 1, 2}).meeting({3, 4, 5}) ==
        predicates::TriangleOverlap::none) {
      continue;
    }
    ++meeting;
    const auto other = needle(random, 0.1);
    OrientedBox grown = around(other);
    grown.include(framed(a));
    ASSERT_FALSE(around(a).apart(around(b)));
    ASSERT_FALSE(around(a).apart(OrientedBox(upright(b))));
    ASSERT_FALSE(OrientedBox(around(a), around(other)).apart(around(b)));
    ASSERT_FALSE(around(b).apart(OrientedBox(around(other), around(a))));
    ASSERT_FALSE(grown.apart(around(b)));
  }
  EXPECT_GT(meeting, 100);
}

TEST(OrientedBox, keeps_parallel_needles_apart_where_upright_boxes_overlap) {
  const Vec3 along(0.5, 0.6, 0.7), across = Vec3(0.6, -0.5, 0) / 100;
  const std::array<Vec3, 3> a = {Vec3::Zero(), along, across};
  const std::array<Vec3, 3> b = {Vec3(2 * across), Vec3(along + 2 * across), Vec3(3 * across)};
  EXPECT_TRUE(upright(a).overlaps(upright(b)));
  EXPECT_TRUE(around(a).apart(around(b)));
  EXPECT_FALSE(OrientedBox(upright(a)).apart(OrientedBox(upright(b))));
}

/// Pairs visited in a tree over the needles of a fan: neighbours meet, others do not.
TEST(BoxTree, visits_few_pairs_of_long_slanted_triangles) {
  constexpr std::uint32_t kCount = 2000;
  const Vec3 along(0.5, 0.5, 0.5), u = along.cross(Vec3::UnitX()) / 2, v = along.cross(u);
  std::vector<std::array<Vec3, 3>> facets;
  const auto edge = [&](std::uint32_t i) -> Vec3 {
    const double angle = 6.283185307179586 * i / kCount;
    return std::cos(angle) * u + std::sin(angle) * v - along / 2;
  };
  for (std::uint32_t i = 0; i < kCount; ++i) {
    facets.push_back({edge(i), edge(i + 1), Vec3(edge(i) + along)});
  }
  std::vector<Box> boxes;
  for (const auto& facet : facets) {
    boxes.push_back(upright(facet));
  }
  const auto visited = [](const BoxTree& tree) {
    std::size_t pairs = 0;
    TreeTraversal(tree).visit([&](std::uint32_t, std::uint32_t) { ++pairs; });
    return pairs;
  };
  EXPECT_GT(visited(BoxTree(boxes)), 100 * kCount);
  EXPECT_LT(visited(BoxTree(support::BulkVector<Box>(boxes.begin(), boxes.end()),
                            [&](std::uint32_t i) { return framed(facets[i]); })),
            40 * kCount);
}

}  // namespace
}  // namespace dupin::boxes
