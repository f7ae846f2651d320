#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::support {

/// Sorts a few, or falls back on the library. Stable.
template <class Item, class Less>
void sort_run(std::span<Item> items, const Less& less) {
  constexpr std::size_t kFew = 16;
  if (items.size() > kFew) {
    std::stable_sort(items.begin(), items.end(), less);
    return;
  }
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (!less(items[i], items[i - 1])) {
      continue;
    }
    const Item item = items[i];
    std::size_t k = i;
    for (; k > 0 && less(item, items[k - 1]); --k) {
      items[k] = items[k - 1];
    }
    items[k] = item;
  }
}

/// Sorts items whose keys differ in the lowest `bits` bits only into as many places elsewhere.
/// Lemma: counted out by the upper ones of these bits, in order, they lie in runs that come one
/// after another by their keys, and those in a run in the order they had; so if each run is sorted
/// and stays stable, so is all. There are about as many runs as items.
template <class Item, class Key, class Less>
void sort_into(std::span<const Item> items, std::span<Item> sorted, int bits, const Key& key,
               const Less& less) {
  const int used = std::min(bits, static_cast<int>(std::bit_width(items.size())));
  const std::size_t mask = (std::size_t{1} << used) - 1;
  const auto run = [&](const Item& item) {
    return (std::size_t{key(item)} >> (bits - used)) & mask;
  };
  std::vector<std::uint32_t> ends(mask + 2, 0);  // first the begin of each run, one further on
  for (const Item& item : items) {
    ++ends[run(item) + 1];
  }
  for (std::size_t r = 0; r <= mask; ++r) {
    ends[r + 1] += ends[r];
  }
  for (const Item& item : items) {
    sorted[ends[run(item)]++] = item;
  }
  for (std::size_t r = 0, begin = 0; r <= mask; begin = ends[r++]) {
    sort_run(sorted.subspan(begin, ends[r] - begin), less);
  }
}

/// Sorts by `less`, in parallel; it compares keys first, which are below `key_end`. Stable. Fast
/// where keys spread over their range.
template <class Item, class Key, class Less>
void sort_by_key(std::vector<Item>& items, std::uint32_t key_end, const Key& key,
                 const Less& less) {
  constexpr int kBucketBits = 10;
  constexpr std::size_t kBuckets = std::size_t{1} << kBucketBits, kMostBlocks = 64;
  if (items.size() < 2 * Block::kSize) {
    const std::vector<Item> given = items;
    sort_into(std::span(given), std::span(items), std::bit_width(key_end), key, less);
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
    const std::size_t count = starts[b + 1] - starts[b];
    sort_into(std::span<const Item>(scattered).subspan(starts[b], count),
              std::span(items).subspan(starts[b], count), shift, key, less);
  });
}

}  // namespace dupin::support
