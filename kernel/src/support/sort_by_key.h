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

/// Numbers of buckets that keys fall into by their upper bits, in order.
class KeyBuckets {
 public:
  static constexpr int kBits = 10;
  static constexpr std::size_t kCount = std::size_t{1} << kBits;

  KeyBuckets(std::uint32_t key_end, std::size_t parts)
      : shift_(std::max(static_cast<int>(std::bit_width(key_end)) - kBits, 0)), offsets_(parts) {}

  /// How many bits of keys in one bucket differ.
  [[nodiscard]] int bits() const { return shift_; }
  /// First all items of each part are counted,
  void count(std::size_t part, std::uint32_t key) { ++offsets_[part][bucket(key)]; }
  /// then what comes before which is found,
  void place() {
    for (std::size_t b = 0, next = 0; b < kCount; ++b) {
      for (auto& of_part : offsets_) {
        next += std::exchange(of_part[b], next);
      }
      starts_[b + 1] = next;
    }
  }
  /// and each item, in the same order, gets the next place of its part and bucket.
  [[nodiscard]] std::size_t next_place(std::size_t part, std::uint32_t key) {
    return offsets_[part][bucket(key)]++;
  }
  [[nodiscard]] std::size_t size() const { return starts_.back(); }
  template <class Item>
  [[nodiscard]] std::span<Item> bucket_of(std::span<Item> scattered, std::size_t b) const {
    return scattered.subspan(starts_[b], starts_[b + 1] - starts_[b]);
  }

 private:
  [[nodiscard]] std::size_t bucket(std::uint32_t key) const { return std::size_t{key >> shift_}; }

  int shift_;
  std::vector<std::array<std::size_t, kCount>> offsets_;  // per part and bucket
  std::array<std::size_t, kCount + 1> starts_{};
};

/// Most blocks that have buckets of their own, and least items of one: buckets are many.
constexpr std::size_t kMostKeyedBlocks = 64, kLeastKeyedBlock = 4096;

[[nodiscard]] constexpr std::size_t keyed_block_size(std::size_t count) {
  return std::max(kLeastKeyedBlock, (count + kMostKeyedBlocks - 1) / kMostKeyedBlocks);
}

/// Sorts by `less`, in parallel; it compares keys first, which are below `key_end`. Stable. Fast
/// where keys spread over their range.
template <class Item, class Key, class Less>
void sort_by_key(std::vector<Item>& items, std::uint32_t key_end, const Key& key,
                 const Less& less) {
  if (items.size() < 2 * kLeastKeyedBlock) {
    const std::vector<Item> given = items;
    sort_into(std::span(given), std::span(items), std::bit_width(key_end), key, less);
    return;
  }
  const std::size_t block_size = keyed_block_size(items.size());
  KeyBuckets buckets(key_end, block_count(items.size(), block_size));
  const auto count = [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      buckets.count(block.number, key(items[i]));
    }
  };
  for_each_block(items.size(), count, block_size);
  buckets.place();
  BulkVector<Item> scattered(items.size());
  const auto scatter = [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      scattered[buckets.next_place(block.number, key(items[i]))] = items[i];
    }
  };
  for_each_block(items.size(), scatter, block_size);
  for_each_in_parallel(KeyBuckets::kCount, [&](std::size_t b) {
    sort_into(std::span<const Item>(buckets.bucket_of(std::span(scattered), b)),
              buckets.bucket_of(std::span(items), b), buckets.bits(), key, less);
  });
}

/// What collect(index, found) calls found(item) with for all indices below `count`, sorted
/// likewise. Each index is asked twice if they are many, so that items are kept nowhere but in
/// their places.
template <class Item, class Collect, class Key, class Less>
[[nodiscard]] BulkVector<Item> collect_by_key(std::size_t count, const Collect& collect,
                                              std::uint32_t key_end, const Key& key,
                                              const Less& less) {
  if (count < 2 * kLeastKeyedBlock) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < count; ++i) {
      collect(i, [&](const Item& item) { items.push_back(item); });
    }
    BulkVector<Item> sorted(items.size());
    sort_into(std::span<const Item>(items), std::span(sorted), std::bit_width(key_end), key, less);
    return sorted;
  }
  const std::size_t block_size = keyed_block_size(count);
  KeyBuckets buckets(key_end, block_count(count, block_size));
  const auto visit = [&](const auto& found) {
    for_each_block(
        count,
        [&](const Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            collect(i, [&](const Item& item) { found(block.number, item); });
          }
        },
        block_size);
  };
  visit([&](std::size_t block, const Item& item) { buckets.count(block, key(item)); });
  buckets.place();
  BulkVector<Item> sorted(buckets.size());
  visit([&](std::size_t block, const Item& item) {
    sorted[buckets.next_place(block, key(item))] = item;
  });
  for_each_in_parallel(KeyBuckets::kCount, [&](std::size_t b) {
    const std::span<Item> bucket = buckets.bucket_of(std::span(sorted), b);
    const std::vector<Item> unsorted(bucket.begin(), bucket.end());
    sort_into(std::span(unsorted), bucket, buckets.bits(), key, less);
  });
  return sorted;
}

}  // namespace dupin::support
