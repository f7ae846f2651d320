#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "arrangement/blocks.h"
#include "box_tree.h"

namespace dupin::detail {

/// The indices below `count` whose boxes, box_of(index), overlap that of some item of the tree,
/// ascending. Quick where boxes with near indices are near each other.
template <class BoxOf>
[[nodiscard]] std::vector<std::uint32_t> boxes_near(const BoxTree& tree, std::size_t count,
                                                    const BoxOf& box_of) {
  constexpr std::size_t kTogether = 64;
  std::vector<std::vector<std::uint32_t>> parts(block_count(count));
  for_each_block(count, [&](const Block& block) {
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
  return joined(std::move(parts));
}

}  // namespace dupin::detail
