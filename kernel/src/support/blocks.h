#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "support/bulk_vector.h"

/// What every folder of the kernel needs and that knows no geometry. Work is done in parallel by
/// blocks of consecutive indices that do not depend on the number of threads, and joined in their
/// order: the same input gives the same bytes (blocks.h; sort_by_key.h sorts likewise). Large
/// arrays leave their memory to the threads that fill it (bulk_vector.h). Partitions into connected
/// sets are disjoint_sets.h; keys become numbers in order of appearance in key_numbering.h, by
/// hash.h. An index that is not there is kNone (none.h). Progress, and being cancelled, is
/// progress_stage.h.
namespace dupin::support {

/// Calls `visit(index)` for all indices below `count`, in parallel.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit);

/// Consecutive indices that one thread deals with. Blocks do not depend on the number of threads,
/// nor does what they find, joined in their order.
struct Block {
  static constexpr std::size_t kSize = 1024;
  std::size_t number, begin, end;
};

[[nodiscard]] constexpr std::size_t block_count(std::size_t count,
                                                std::size_t block_size = Block::kSize) {
  return (count + block_size - 1) / block_size;
}

/// Calls `visit(block)` for all blocks of the indices below `count`, in parallel.
template <class Visit>
void for_each_block(std::size_t count, const Visit& visit, std::size_t block_size = Block::kSize) {
  const auto visit_block = [&](std::size_t b) {
    visit(Block{b, b * block_size, std::min((b + 1) * block_size, count)});
  };
  if (count <= block_size) {
    if (count > 0) {
      visit_block(0);
    }
    return;
  }
  for_each_in_parallel(block_count(count, block_size), visit_block);
}

/// Gives all items the value, in parallel.
template <class Items>
void fill_all(Items& items, const typename Items::value_type& value) {
  for_each_block(items.size(), [&](const Block& block) {
    std::fill(items.begin() + static_cast<std::ptrdiff_t>(block.begin),
              items.begin() + static_cast<std::ptrdiff_t>(block.end), value);
  });
}

template <class Item>
[[nodiscard]] std::vector<Item> joined(std::vector<std::vector<Item>> parts) {
  if (parts.size() == 1) {
    return std::move(parts.front());
  }
  std::size_t count = 0;
  for (const std::vector<Item>& part : parts) {
    count += part.size();
  }
  std::vector<Item> all;
  reserve_bulk(all, count);
  for (std::vector<Item>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = std::vector<Item>();  // all at once would take as much memory again
  }
  return all;
}

/// What `collect(index, items)` appends to `items` for all indices below `count`, in their order,
/// by blocks.
template <class Item, class Collect>
[[nodiscard]] std::vector<std::vector<Item>> collect_by_blocks(
    std::size_t count, const Collect& collect, std::size_t block_size = Block::kSize) {
  std::vector<std::vector<Item>> parts(block_count(count, block_size));
  const auto collect_all = [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      collect(i, parts[block.number]);
    }
  };
  for_each_block(count, collect_all, block_size);
  return parts;
}

/// The same, joined.
template <class Item, class Collect>
[[nodiscard]] std::vector<Item> collect_in_order(std::size_t count, const Collect& collect,
                                                 std::size_t block_size = Block::kSize) {
  return joined(collect_by_blocks<Item>(count, collect, block_size));
}

/// The indices below `count`, ascending, that holds(index) is true of.
template <class Holds>
[[nodiscard]] std::vector<std::uint32_t> indices_where(std::size_t count, const Holds& holds,
                                                       std::size_t block_size = Block::kSize) {
  return collect_in_order<std::uint32_t>(
      count,
      [&](std::size_t i, std::vector<std::uint32_t>& found) {
        if (const auto index = static_cast<std::uint32_t>(i); holds(index)) {
          found.push_back(index);
        }
      },
      block_size);
}

/// Items from `begin` to before `end` that have the same key, while their neighbours have others.
struct IndexRange {
  std::uint32_t begin, end;
};

template <class Items, class Key>
[[nodiscard]] std::vector<IndexRange> ranges_of_equal(const Items& items, const Key& key) {
  return collect_in_order<IndexRange>(
      items.size(), [&](std::size_t i, std::vector<IndexRange>& found) {
        if (i == 0 || key(items[i - 1]) != key(items[i])) {
          std::size_t end = i + 1;
          while (end < items.size() && key(items[end]) == key(items[i])) {
            ++end;
          }
          found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end)});
        }
      });
}

/// Ranks, in ascending order, the indices below a count that a condition holds for.
template <class Condition>
class Ranking {
 public:
  Ranking(std::size_t count, Condition holds)
      : count_(count), holds_(std::move(holds)), first_rank_(block_count(count) + 1) {
    for_each_block(count, [&](const Block& block) {
      std::size_t& holding = first_rank_[block.number + 1];
      for (std::size_t i = block.begin; i < block.end; ++i) {
        holding += holds_(i) ? 1 : 0;
      }
    });
    std::partial_sum(first_rank_.begin(), first_rank_.end(), first_rank_.begin());
  }
  /// How many indices the condition holds for.
  [[nodiscard]] std::size_t size() const { return first_rank_.back(); }
  /// Calls `visit(index, rank)` for these, in parallel. Earlier calls may not change whether the
  /// condition holds for later indices.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for_each_block(count_, [&](const Block& block) {
      std::size_t rank = first_rank_[block.number];
      for (std::size_t i = block.begin; i < block.end; ++i) {
        if (holds_(i)) {
          visit(i, rank++);
        }
      }
    });
  }

 private:
  std::size_t count_;
  Condition holds_;
  std::vector<std::size_t> first_rank_;  // of each block, and one past the last
};

}  // namespace dupin::support
