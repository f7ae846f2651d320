#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace dupin::detail {

/// A partition of 0 .. n-1 that sets can be united in. The lowest member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent_[high] = low;
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      roots += parent_[i] == i ? 1 : 0;
    }
    return roots;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace dupin::detail
