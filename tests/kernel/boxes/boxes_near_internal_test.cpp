#include <algorithm>

#include <gtest/gtest.h>

#include "boxes/bounds.h"
#include "boxes/boxes_near.h"
#include "kernel/boxes/random_boxes_internal.h"

namespace dupin::boxes {
namespace {

TEST(BoxesNear, are_those_that_overlap_some_item) {
  const std::vector<Box> items = random_boxes(60, 1), others = random_boxes(9000, 2);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    if (std::ranges::any_of(items, [&](const Box& item) { return item.overlaps(others[i]); })) {
      expected.push_back(i);
    }
  }
  ASSERT_GT(expected.size(), 50);
  ASSERT_LT(expected.size(), others.size());
  const auto near =
      boxes_near(BoxTree(items), others.size(), [&](std::uint32_t i) { return others[i]; });
  EXPECT_EQ(near, expected);
}

TEST(BoxesNear, of_other_groups_are_all_found) {
  // Clusters of boxes, a group each, along a line; some boxes have no group.
  constexpr std::uint32_t kClusters = 20, kSize = 256;
  std::vector<Box> boxes;
  std::vector<std::uint32_t> groups;
  for (std::uint32_t c = 0; c < kClusters; ++c) {
    const float shift = 0.09F * static_cast<float>(c) - 0.9F;
    for (Box box : random_boxes(kSize, c)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const float middle = k == 0 ? shift + (c % 3 == 0 ? 0.03F : 0) : 0;
        box.low[k] = box.low[k] * 0.03F + middle;
        box.high[k] = box.high[k] * 0.03F + middle;
      }
      boxes.push_back(box);
      groups.push_back(c == 7 && boxes.size() % 50 == 0 ? support::kNone : c);
    }
  }
  const auto near = boxes_near_other_groups(groups, [&](std::uint32_t i) { return boxes[i]; });
  EXPECT_TRUE(std::ranges::is_sorted(near));
  std::size_t apart = 0;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    bool is_near = groups[i] == support::kNone;
    for (std::uint32_t k = 0; k < boxes.size() && !is_near; ++k) {
      is_near = groups[k] != groups[i] && boxes[i].overlaps(boxes[k]);
    }
    const bool found = std::ranges::binary_search(near, i);
    ASSERT_TRUE(found || !is_near) << i;
    apart += found ? 0 : 1;
  }
  EXPECT_GT(apart, boxes.size() / 8) << "far groups are not looked at";
}

TEST(Bounds, are_those_of_all_points) {
  const std::vector<Vec3> points = {{1, 5, -2}, {-3, 0, 7}, {0, 9, 0}};
  EXPECT_EQ(bounds_of(points).min(), Vec3(-3, 0, -2));
  EXPECT_EQ(bounds_of(points).max(), Vec3(1, 9, 7));
  EXPECT_TRUE(bounds_of({}).isEmpty());
}

}  // namespace
}  // namespace dupin::boxes
