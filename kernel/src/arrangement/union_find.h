#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace dupin::detail {

/// Classes of 0 .. size - 1; the lowest member stands for its class.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t i) const {
    while (parent_[i] != i) {
      i = parent_[i];
    }
    return i;
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[a > b ? a : b] = a > b ? b : a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace dupin::detail
