#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace dupin::boxes {

/// A box along the axes, and in the single precision coordinates, of a BoxQuantizer.
struct Box {
  std::array<float, 3> low, high;

  [[nodiscard]] bool overlaps(const Box& other) const {
    const auto reaches = [](float a, float b) { return a <= b ? 1U : 0U; };  // without branches
    return (reaches(low[0], other.high[0]) & reaches(other.low[0], high[0]) &
            reaches(low[1], other.high[1]) & reaches(other.low[1], high[1]) &
            reaches(low[2], other.high[2]) & reaches(other.low[2], high[2])) != 0;
  }
  [[nodiscard]] bool contains(const Box& other) const {
    for (int k = 0; k < 3; ++k) {
      if (other.low[k] < low[k] || high[k] < other.high[k]) {
        return false;
      }
    }
    return true;
  }
  /// Makes the box contain `other` too.
  void join(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  /// Contains nothing, overlaps nothing.
  [[nodiscard]] static Box nothing() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  }
  [[nodiscard]] bool is_nothing() const { return high[0] < low[0]; }
};

}  // namespace dupin::boxes
