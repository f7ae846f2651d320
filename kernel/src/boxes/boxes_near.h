#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxes/box_tree.h"
#include "boxes/tree_traversal.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/none.h"

namespace dupin::boxes {

/// The indices below `count` whose boxes, box_of(index), overlap that of some item of the tree,
/// ascending. Quick where boxes with near indices are near each other.
template <class BoxOf>
[[nodiscard]] std::vector<std::uint32_t> boxes_near(const BoxTree& tree, std::size_t count,
                                                    const BoxOf& box_of) {
  constexpr std::size_t kTogether = 64;
  std::vector<std::vector<std::uint32_t>> parts(support::block_count(count));
  support::for_each_block(count, [&](const support::Block& block) {
    std::array<Box, kTogether> boxes;
    for (std::size_t begin = block.begin; begin < block.end; begin += kTogether) {
      const std::size_t size = std::min(kTogether, block.end - begin);
      Box all = Box::nothing();
      for (std::size_t i = 0; i < size; ++i) {
        boxes[i] = box_of(static_cast<std::uint32_t>(begin + i));
        all.join(boxes[i]);
      }
      const std::size_t end = tree.overlaps(all) ? size : 0;
      for (std::size_t i = 0; i < end; ++i) {
        if (tree.overlaps(boxes[i])) {
          parts[block.number].push_back(static_cast<std::uint32_t>(begin + i));
        }
      }
    }
  });
  return support::joined(std::move(parts));
}

/// The indices of groups whose boxes, box_of(index), may overlap one of another group, ascending;
/// those of support::kNone are a group each. Quick where boxes with near indices are near each
/// other and of one group: those of far groups have one box in common.
template <class BoxOf>
[[nodiscard]] std::vector<std::uint32_t> boxes_near_other_groups(
    std::span<const std::uint32_t> groups, const BoxOf& box_of) {
  constexpr std::size_t kTogether = 64;
  const auto end_of = [&](std::size_t run) {
    return std::min((run + 1) * kTogether, groups.size());
  };
  const std::size_t runs = (groups.size() + kTogether - 1) / kTogether;
  support::BulkVector<Box> boxes(runs);
  std::vector<std::uint32_t> group(runs);
  support::for_each_block(runs, [&](const support::Block& block) {
    for (std::size_t run = block.begin; run < block.end; ++run) {
      boxes[run] = Box::nothing();
      group[run] = groups[run * kTogether];
      for (std::size_t i = run * kTogether; i < end_of(run); ++i) {
        boxes[run].join(box_of(static_cast<std::uint32_t>(i)));
        group[run] = group[run] == groups[i] ? groups[i] : support::kNone;
      }
    }
  });
  const BoxTree tree(std::span<const Box>(boxes), group);
  std::vector<std::uint8_t> near(runs);
  std::ranges::transform(group, near.begin(),
                         [](std::uint32_t g) { return g == support::kNone ? 1 : 0; });
  TreeTraversal(tree).visit(
      [&](std::uint32_t i, std::uint32_t k) { near[tree.items()[i]] = near[tree.items()[k]] = 1; });
  std::vector<std::uint32_t> found;
  for (std::size_t run = 0; run < runs; ++run) {
    for (std::size_t i = run * kTogether; near[run] != 0 && i < end_of(run); ++i) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return found;
}

}  // namespace dupin::boxes
