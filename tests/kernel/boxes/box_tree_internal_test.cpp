#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "boxes/box_tree.h"
#include "kernel/boxes/random_boxes_internal.h"
#include "predicates/triangle_overlap.h"

namespace dupin::boxes {
namespace {

std::vector<std::uint32_t> visited(const BoxTree& tree, const Box& box) {
  std::vector<std::uint32_t> items;
  tree.visit(box, [&](std::uint32_t item) { items.push_back(item); });
  std::ranges::sort(items);
  return items;
}

std::vector<std::uint32_t> overlapping(const std::vector<Box>& boxes, const Box& box) {
  std::vector<std::uint32_t> items;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].overlaps(box)) {
      items.push_back(i);
    }
  }
  return items;
}

TEST(BoxTree, visits_the_boxes_that_overlap_another_one) {
  for (const std::uint32_t count : {0U, 1U, 4U, 5U, 63U, 1000U}) {
    std::vector<Box> boxes = random_boxes(count, count);
    if (count > 4) {
      boxes[2] = Box::nothing();
    }
    const BoxTree tree(boxes);
    std::size_t found = 0;
    for (const Box& box : random_boxes(300, 77)) {
      const auto expected = overlapping(boxes, box);
      ASSERT_EQ(visited(tree, box), expected);
      ASSERT_EQ(tree.overlaps(box), !expected.empty());
      found += expected.size();
    }
    EXPECT_TRUE(count < 1000 || found > 20) << found;
  }
}

TEST(BoxTree, of_boxes_in_any_order_has_each_item_once) {
  const BoxTree tree(random_boxes(5000, 9));
  std::vector<std::uint32_t> items(tree.items().begin(), tree.items().end());
  EXPECT_FALSE(std::ranges::is_sorted(items)) << "far boxes come together otherwise";
  std::ranges::sort(items);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    ASSERT_EQ(items[i], i);
  }
}

TEST(BoxTree, finds_boxes_that_have_grown) {
  std::mt19937 random(5);
  std::vector<Box> boxes = random_boxes(200, 5);
  BoxTree tree(boxes);
  for (const Box& more : random_boxes(300, 6)) {
    const auto item = static_cast<std::uint32_t>(random() % boxes.size());
    boxes[item].join(more);
    tree.grow(item, more, {});
    const Box asked = random_boxes(1, static_cast<std::uint32_t>(random()))[0];
    ASSERT_EQ(visited(tree, asked), overlapping(boxes, asked));
  }
}

/// A bundle of long thin triangles through a cube, all slanted in nearly the same way.
struct Needles {
  Needles() {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> offset(-0.02, 0.02);
    for (std::uint32_t i = 0; i < 64 * 64; ++i) {
      const Vec3 from(i % 64 / 64.0, i / 64 / 64.0, 0);
      const Vec3 to = from + Vec3(2 + offset(random), 2 + offset(random), 4);
      points.insert(points.end(), {from, to, to + Vec3(0.005, 0, 0)});
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
  }
  [[nodiscard]] FramedTriangle framed(const BoxQuantizer& frame, std::uint32_t i) const {
    return frame.map(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  }
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

TEST(BoxTree, with_oriented_boxes_visits_all_triangles_that_meet_another_one) {
  const Needles needles;
  const BoxQuantizer frame(needles.points);
  support::BulkVector<Box> boxes;
  for (std::uint32_t i = 0; i < needles.triangles.size(); ++i) {
    boxes.push_back(frame.around(needles.framed(frame, i)));
  }
  const BoxTree upright{std::span<const Box>(boxes)};
  const BoxTree tree(boxes, [&](std::uint32_t i) { return needles.framed(frame, i); });
  ASSERT_TRUE(tree.is_oriented());
  std::size_t met = 0, seen = 0, seen_upright = 0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    std::vector<std::uint32_t> near;
    const FramedTriangle triangle = needles.framed(frame, i);
    EXPECT_FALSE(tree.visit_until(boxes[i], {&triangle, 1}, [&](std::uint32_t k, const Box& box) {
      EXPECT_EQ(box.low, boxes[k].low);
      near.push_back(k);
      return false;
    }));
    upright.visit(boxes[i], [&](std::uint32_t) { ++seen_upright; });
    std::size_t count = 0;
    EXPECT_TRUE(tree.visit_until(boxes[i], {&triangle, 1}, [&](std::uint32_t k, const Box&) {
      EXPECT_EQ(k, near[count]) << "in the same order";
      return ++count == (near.size() + 1) / 2;
    }));
    EXPECT_EQ(count, (near.size() + 1) / 2) << "and no further";
    std::ranges::sort(near);
    seen += near.size();
    const predicates::TriangleOverlapTest test(needles.points, needles.triangles[i]);
    for (std::uint32_t k = 0; k < needles.triangles.size(); ++k) {
      if (k != i && test.meeting(needles.triangles[k]) != predicates::TriangleOverlap::none) {
        ASSERT_TRUE(std::ranges::binary_search(near, k)) << i << " and " << k;
        ++met;
      }
    }
  }
  EXPECT_GT(met, 0);
  EXPECT_LT(2 * seen, seen_upright) << "far fewer than boxes along the axes name";
}

}  // namespace
}  // namespace dupin::boxes
