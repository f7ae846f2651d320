#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace dupin::assembly {

/// Sets of things, each alone at first, that come together; the lowest of a set stands for it.
class Groups {
 public:
  explicit Groups(std::size_t count) : leader_(count) {
    std::iota(leader_.begin(), leader_.end(), std::uint32_t{0});
  }
  [[nodiscard]] std::uint32_t of(std::uint32_t one) {
    while (leader_[one] != one) {
      one = leader_[one] = leader_[leader_[one]];
    }
    return one;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = of(a), second = of(b);
    leader_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> leader_;
};

}  // namespace dupin::assembly
