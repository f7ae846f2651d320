#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "boxes/tree_traversal.h"
#include "kernel/boxes/random_boxes_internal.h"

namespace dupin::boxes {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Pairs = std::map<Pair, int>;  // and how often

/// Boxes of a strip of quads, each by its neighbours.
std::vector<Box> strip(std::uint32_t count) {
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(count);
    boxes.push_back({{x, 0, 0}, {x + 1 / static_cast<float>(count), 0.1F, 0}});
  }
  return boxes;
}

bool keeps_order(const BoxTree& tree) {
  return std::is_sorted(tree.items().begin(), tree.items().end());
}

Pairs visited(const BoxTree& one, const BoxTree& other, std::size_t tasks) {
  Pairs pairs;
  const TreeTraversal both = &one == &other ? TreeTraversal(one) : TreeTraversal(one, other);
  for (const TreeTraversal::Nodes& nodes : both.tasks(tasks)) {
    both.visit(nodes, [&](std::uint32_t i, std::uint32_t k) {
      Pair pair{one.items()[i], other.items()[k]};
      if (&one == &other && pair.second < pair.first) {
        std::swap(pair.first, pair.second);
      }
      ++pairs[pair];
    });
  }
  return pairs;
}

TEST(TreePairs, visits_each_pair_of_overlapping_boxes_of_a_tree_once) {
  for (const std::uint32_t count : {0U, 1U, 2U, 5U, 64U, 700U}) {
    const std::vector<Box> boxes = random_boxes(count, count);
    Pairs expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t k = i + 1; k < count; ++k) {
        if (boxes[i].overlaps(boxes[k])) {
          expected[{i, k}] = 1;
        }
      }
    }
    const BoxTree tree(boxes);
    for (const std::size_t tasks : {1U, 16U, 100000U}) {
      EXPECT_EQ(visited(tree, tree, tasks), expected) << count << " boxes, " << tasks << " tasks";
    }
  }
}

TEST(TreePairs, visits_each_pair_of_overlapping_boxes_of_two_trees_once) {
  for (const auto& [one, other] : {Pair(0, 10), Pair(1, 500), Pair(500, 3), Pair(300, 400)}) {
    const std::vector<Box> boxes = random_boxes(one, 1), others = random_boxes(other, 2);
    Pairs expected;
    for (std::uint32_t i = 0; i < one; ++i) {
      for (std::uint32_t k = 0; k < other; ++k) {
        if (boxes[i].overlaps(others[k])) {
          expected[{i, k}] = 1;
        }
      }
    }
    for (const std::size_t tasks : {1U, 16U, 100000U}) {
      EXPECT_EQ(visited(BoxTree(boxes), BoxTree(others), tasks), expected) << one << ", " << other;
    }
  }
}

TEST(BoxTree, keeps_the_order_of_boxes_whose_neighbours_come_together) {
  std::vector<Box> boxes = strip(10000);
  EXPECT_TRUE(keeps_order(BoxTree(boxes)));
  std::shuffle(boxes.begin(), boxes.end(), std::mt19937(1));
  EXPECT_FALSE(keeps_order(BoxTree(boxes)));
}

TEST(BoxTree, gives_up_an_order_in_which_runs_of_neighbours_lie_anywhere) {
  const std::vector<Box> boxes = strip(64 * 1000);
  std::vector<std::uint32_t> runs(1000);
  std::iota(runs.begin(), runs.end(), 0U);
  std::shuffle(runs.begin(), runs.end(), std::mt19937(1));
  std::vector<Box> mixed;
  for (const std::uint32_t run : runs) {
    mixed.insert(mixed.end(), boxes.begin() + 64 * run, boxes.begin() + 64 * (run + 1));
  }
  EXPECT_FALSE(keeps_order(BoxTree(mixed)));
}

}  // namespace
}  // namespace dupin::boxes
