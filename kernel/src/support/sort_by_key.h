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
  /// First all items of each part are counted, part by part,
  template <class Items, class Key>
  void count(std::size_t part, const Items& items, const Key& key) {
    for (const auto& item : items) {
      ++offsets_[part][bucket(key(item))];
    }
  }
  /// then what comes before which is found,
  void place() {
    for (std::size_t b = 0, next = 0; b < kCount; ++b) {
      for (auto& of_part : offsets_) {
        next += std::exchange(of_part[b], next);
      }
      starts_[b + 1] = next;
    }
  }
  /// and each item is put in its place.
  template <class Items, class Key, class Item>
  void scatter(std::size_t part, const Items& items, const Key& key, std::span<Item> scattered) {
    for (const auto& item : items) {
      scattered[offsets_[part][bucket(key(item))]++] = item;
    }
  }
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

/// Sorts by `less`, in parallel; it compares keys first, which are below `key_end`. Stable. Fast
/// where keys spread over their range.
template <class Item, class Key, class Less>
void sort_by_key(std::vector<Item>& items, std::uint32_t key_end, const Key& key,
                 const Less& less) {
  constexpr std::size_t kMostBlocks = 64;
  if (items.size() < 2 * Block::kSize) {
    const std::vector<Item> given = items;
    sort_into(std::span(given), std::span(items), std::bit_width(key_end), key, less);
    return;
  }
  const std::size_t block_size =
      std::max(Block::kSize, (items.size() + kMostBlocks - 1) / kMostBlocks);
  const std::span<Item> all(items);
  KeyBuckets buckets(key_end, block_count(items.size(), block_size));
  const auto part = [&](const Block& block) {
    return all.subspan(block.begin, block.end - block.begin);
  };
  for_each_block(
      items.size(), [&](const Block& block) { buckets.count(block.number, part(block), key); },
      block_size);
  buckets.place();
  BulkVector<Item> scattered(items.size());
  for_each_block(
      items.size(),
      [&](const Block& block) {
        buckets.scatter(block.number, part(block), key, std::span(scattered));
      },
      block_size);
  for_each_in_parallel(KeyBuckets::kCount, [&](std::size_t b) {
    sort_into(std::span<const Item>(buckets.bucket_of(std::span(scattered), b)),
              buckets.bucket_of(all, b), buckets.bits(), key, less);
  });
}

/// The items of all parts, sorted likewise; takes little more memory than they do.
template <class Item, class Key, class Less>
[[nodiscard]] BulkVector<Item> sorted_by_key(std::vector<std::vector<Item>> parts,
                                             std::uint32_t key_end, const Key& key,
                                             const Less& less) {
  constexpr std::size_t kMostRuns = 64;
  std::size_t count = 0;
  for (const std::vector<Item>& part : parts) {
    count += part.size();
  }
  // Runs of parts, so that few have buckets of their own.
  const std::size_t run_size = std::max<std::size_t>(1, (parts.size() + kMostRuns - 1) / kMostRuns);
  KeyBuckets buckets(key_end, block_count(parts.size(), run_size));
  for_each_block(
      parts.size(),
      [&](const Block& run) {
        for (std::size_t p = run.begin; p < run.end; ++p) {
          buckets.count(run.number, parts[p], key);
        }
      },
      run_size);
  buckets.place();
  BulkVector<Item> sorted(count);
  for_each_block(
      parts.size(),
      [&](const Block& run) {
        for (std::size_t p = run.begin; p < run.end; ++p) {
          buckets.scatter(run.number, parts[p], key, std::span(sorted));
          parts[p] = std::vector<Item>();
        }
      },
      run_size);
  for_each_in_parallel(KeyBuckets::kCount, [&](std::size_t b) {
    const std::span<Item> bucket = buckets.bucket_of(std::span(sorted), b);
    const std::vector<Item> unsorted(bucket.begin(), bucket.end());
    sort_into(std::span(unsorted), bucket, buckets.bits(), key, less);
  });
  return sorted;
}

}  // namespace dupin::support
