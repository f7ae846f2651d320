#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dupin::meshing {

/// What is at each point: items of `corners` that have it.
template <class Item>
class Incidence {
 public:
  Incidence(const std::vector<Item>& items, std::size_t points) : starts_(points + 1, 0) {
    for (const Item& item : items) {
      for (const std::uint32_t v : item) {
        ++starts_[v + 1];
      }
    }
    for (std::size_t v = 0; v < points; ++v) {
      starts_[v + 1] += starts_[v];
    }
    items_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      for (const std::uint32_t v : items[i]) {
        items_[next[v]++] = i;
      }
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t point) const {
    return std::span(items_).subspan(starts_[point], starts_[point + 1] - starts_[point]);
  }

 private:
  std::vector<std::uint32_t> starts_, items_;
};

}  // namespace dupin::meshing
