#include <random>

#include <gtest/gtest.h>

#include "support/sort_by_key.h"

namespace dupin::support {
namespace {

struct Item {
  std::uint32_t key, order;
  friend bool operator==(const Item&, const Item&) = default;
};

std::vector<Item> random_items(std::size_t count, std::uint32_t key_end, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::uint32_t> key(0, key_end - 1);
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < count; ++i) {
    items.push_back({key(random), i});
  }
  return items;
}

bool by_key(const Item& a, const Item& b) { return a.key < b.key; }

TEST(SortByKey, sorts_like_a_stable_sort) {
  // Below and above the number from which it sorts by buckets; keys that fill few or all of them.
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5000}, Block::kSize,
                                  2 * Block::kSize, 5 * Block::kSize + 17}) {
    for (const std::uint32_t key_end : {1U, 2U, 1000U, 1025U, 1U << 20, 0xffffffffU}) {
      std::vector<Item> items = random_items(count, key_end, key_end % 97), expected = items;
      std::stable_sort(expected.begin(), expected.end(), by_key);
      sort_by_key(
          items, key_end, [](const Item& item) { return item.key; }, by_key);
      EXPECT_EQ(items, expected) << count << " below " << key_end;
    }
  }
}

TEST(SortByKey, sorts_keys_that_crowd_in_one_place) {
  // Many in one run, a few in the runs around it, for the small way and the large one.
  for (const std::size_t count : {std::size_t{17}, std::size_t{3000}, 4 * Block::kSize}) {
    std::vector<Item> items = random_items(count, 50, 7);
    for (Item& item : items) {
      item.key += item.order % 10 == 0 ? item.order << 10 : 1U << 30;
    }
    std::vector<Item> expected = items;
    std::stable_sort(expected.begin(), expected.end(), by_key);
    sort_by_key(
        items, 1U << 31, [](const Item& item) { return item.key; }, by_key);
    EXPECT_EQ(items, expected) << count;
  }
}

TEST(CollectByKey, sorts_what_is_found_like_a_stable_sort) {
  // Of each index none, one or more; fewer and more than fill the blocks with buckets of their own.
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5000},
                                  3 * Block::kSize, 70 * Block::kSize + 5}) {
    for (const std::uint32_t key_end : {1U, 1000U, 1U << 20, 0xffffffffU}) {
      const std::vector<Item> items = random_items(2 * count, key_end, key_end % 89);
      const auto collect = [&](std::size_t i, const auto& found) {
        for (std::size_t k = 0; k < i % 4 % 3; ++k) {
          found(items[2 * i + k]);
        }
      };
      std::vector<Item> expected;
      for (std::size_t i = 0; i < count; ++i) {
        collect(i, [&](const Item& item) { expected.push_back(item); });
      }
      std::stable_sort(expected.begin(), expected.end(), by_key);
      const BulkVector<Item> sorted = collect_by_key<Item>(
          count, collect, key_end, [](const Item& item) { return item.key; }, by_key);
      EXPECT_TRUE(std::ranges::equal(sorted, expected)) << count << " below " << key_end;
    }
  }
}

TEST(SortByKey, compares_further_among_equal_keys) {
  const auto later_first = [](const Item& a, const Item& b) {
    return a.key != b.key ? a.key < b.key : a.order > b.order;
  };
  std::vector<Item> items = random_items(3 * Block::kSize, 100, 1), expected = items;
  std::sort(expected.begin(), expected.end(), later_first);
  sort_by_key(
      items, 100, [](const Item& item) { return item.key; }, later_first);
  EXPECT_EQ(items, expected);
}

}  // namespace
}  // namespace dupin::support
