#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace dupin::support {

/// A partition of 0 .. n-1 that sets can be united in. The lowest member stands for its set.
/// Threads may call find() and unite() at the same time.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  /// Adds sets of one member each.
  void add(std::size_t count) {
    const std::size_t first = parent_.size();
    parent_.resize(first + count);
    std::iota(parent_.begin() + static_cast<std::ptrdiff_t>(first), parent_.end(),
              static_cast<std::uint32_t>(first));
  }
  // Parents are lower than their children, and only roots are ever given to another set: whatever
  // ancestor a thread sees remains one.
  [[nodiscard]] std::uint32_t find(std::uint32_t member) {
    for (std::uint32_t up = parent(member).load(std::memory_order_relaxed); up != member;
         up = parent(member).load(std::memory_order_relaxed)) {
      const std::uint32_t above = parent(up).load(std::memory_order_relaxed);
      if (above != up) {
        parent(member).store(above, std::memory_order_relaxed);
      }
      member = above;
    }
    return member;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    if (parent(a).load(std::memory_order_relaxed) == parent(b).load(std::memory_order_relaxed)) {
      return;  // as most often: neighbours have one parent already
    }
    for (;;) {
      const std::uint32_t root_a = find(a), root_b = find(b);
      if (root_a == root_b) {
        return;
      }
      std::uint32_t high = std::max(root_a, root_b);
      const std::uint32_t low = std::min(root_a, root_b);
      if (parent(high).compare_exchange_strong(high, low, std::memory_order_relaxed)) {
        return;
      }
    }
  }
  /// Per member the lowest one of its set.
  [[nodiscard]] std::vector<std::uint32_t> representatives() {
    std::vector<std::uint32_t> lowest(parent_.size());
    for (std::uint32_t member = 0; member < lowest.size(); ++member) {
      lowest[member] = parent_[member] == member ? member : lowest[parent_[member]];
    }
    return lowest;
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      roots += parent_[i] == i ? 1 : 0;
    }
    return roots;
  }

 private:
  [[nodiscard]] std::atomic_ref<std::uint32_t> parent(std::uint32_t member) {
    return std::atomic_ref(parent_[member]);
  }

  std::vector<std::uint32_t> parent_;
};

}  // namespace dupin::support
