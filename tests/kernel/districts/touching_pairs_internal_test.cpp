#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "districts/touching_pairs.h"
#include "dupin/kernel/vec.h"

namespace dupin::districts {
namespace {

using Box = Eigen::AlignedBox3d;

TouchingPairs of_all(const std::vector<Box>& boxes) {
  TouchingPairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (!boxes[i].isEmpty() && !boxes[j].isEmpty() && boxes[i].intersects(boxes[j])) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

// Boxes at whole places in a cube, so that many touch in a face, an edge or a corner only.
std::vector<Box> random_boxes(std::mt19937& random, std::size_t count, int cube, double unit) {
  std::uniform_int_distribution<int> place(0, cube), size(0, 2);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 low(place(random), place(random), place(random));
    const Vec3 extent(size(random), size(random), size(random));
    boxes.emplace_back(low * unit, (low + extent) * unit);
  }
  return boxes;
}

void expect_all_found(const std::vector<Box>& boxes) {
  auto found = touching_pairs(boxes);
  ASSERT_TRUE(found.has_value());
  std::ranges::sort(*found);
  EXPECT_EQ(*found, of_all(boxes));
}

TEST(TouchingPairs, are_those_of_a_search_of_all) {
  std::mt19937 random(5);
  for (const std::size_t count : {0, 1, 2, 64, 65, 1000, 3000}) {
    for (const double unit : {1.0, 0.1, 1e-320, 1e298}) {
      SCOPED_TRACE(testing::Message() << count << " of " << unit);
      expect_all_found(random_boxes(random, count, 30, unit));
    }
  }
}

TEST(TouchingPairs, of_boxes_with_nothing_in_them_are_none_and_of_infinite_ones_all) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::mt19937 random(6);
  for (const std::size_t count : {40, 100}) {
    std::vector<Box> boxes = random_boxes(random, count, 30, 1);
    boxes[3] = boxes[17] = Box();
    boxes[5] = {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
    boxes[20] = {Vec3(15, -kInfinity, 0), Vec3(16, kInfinity, 1)};
    boxes[21] = {Vec3(15, 1e305, 0), Vec3(16, 1e308, 1)};
    expect_all_found(boxes);
  }
  expect_all_found(std::vector<Box>(1000));
}

TEST(TouchingPairs, are_not_looked_for_where_all_touch) {
  std::mt19937 random(7);
  EXPECT_FALSE(touching_pairs(random_boxes(random, 2000, 3, 1)));
}

}  // namespace
}  // namespace dupin::districts
