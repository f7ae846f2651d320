#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace dupin::support {

template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// 0 to count - 1.
[[nodiscard]] inline std::vector<std::uint32_t> numbers_below(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// The items at the places given, in their order.
template <class Item>
[[nodiscard]] std::vector<Item> selected(std::span<const Item> items,
                                         std::span<const std::uint32_t> places) {
  std::vector<Item> some;
  some.reserve(places.size());
  for (const std::uint32_t place : places) {
    some.push_back(items[place]);
  }
  return some;
}

}  // namespace dupin::support
