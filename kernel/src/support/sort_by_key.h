#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::support {

/// Sorts by `less`, in parallel; it compares keys first, which are below `key_end`. Stable. Fast
/// where keys spread over their range.
template <class Item, class Key, class Less>
void sort_by_key(std::vector<Item>& items, std::uint32_t key_end, const Key& key,
                 const Less& less) {
  constexpr int kBucketBits = 10;
  constexpr std::size_t kBuckets = std::size_t{1} << kBucketBits, kMostBlocks = 64;
  if (items.size() < 2 * Block::kSize) {
    std::stable_sort(items.begin(), items.end(), less);
    return;
  }
  const int shift = std::max(static_cast<int>(std::bit_width(key_end)) - kBucketBits, 0);
  const auto bucket = [&](const Item& item) { return std::size_t{key(item) >> shift}; };
  // Per block and bucket, how many items there are; then where the first goes.
  const std::size_t block_size =
      std::max(Block::kSize, (items.size() + kMostBlocks - 1) / kMostBlocks);
  std::vector<std::array<std::size_t, kBuckets>> offsets(block_count(items.size(), block_size));
  for_each_block(
      items.size(),
      [&](const Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
          ++offsets[block.number][bucket(items[i])];
        }
      },
      block_size);
  std::array<std::size_t, kBuckets + 1> starts{};
  for (std::size_t b = 0, next = 0; b < kBuckets; ++b) {
    for (auto& of_block : offsets) {
      next += std::exchange(of_block[b], next);
    }
    starts[b + 1] = next;
  }
  BulkVector<Item> scattered(items.size());
  for_each_block(
      items.size(),
      [&](const Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
          scattered[offsets[block.number][bucket(items[i])]++] = items[i];
        }
      },
      block_size);
  for_each_in_parallel(kBuckets, [&](std::size_t b) {
    const auto begin = scattered.begin() + static_cast<std::ptrdiff_t>(starts[b]),
               end = scattered.begin() + static_cast<std::ptrdiff_t>(starts[b + 1]);
    std::stable_sort(begin, end, less);
    std::copy(begin, end, items.begin() + static_cast<std::ptrdiff_t>(starts[b]));
  });
}

}  // namespace dupin::support
