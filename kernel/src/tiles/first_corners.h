#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dupin::tiles {

/// Which corners of all facets, corner 3f + k being the k-th of facet f, are the first ones at
/// their places. Their ranks are the numbers of points in order of appearance.
class FirstCorners {
 public:
  explicit FirstCorners(std::uint64_t facets) : words_(3 * facets / kBits + 1) {}

  void set(std::uint64_t corner) { words_[corner / kBits] |= bit(corner); }
  /// Behind the last set(), and before the first rank().
  void count() {
    before_.clear();
    count_ = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (i % kStep == 0) {
        before_.push_back(count_);
      }
      count_ += static_cast<std::uint64_t>(std::popcount(words_[i]));
    }
  }
  [[nodiscard]] std::uint64_t size() const { return count_; }
  /// How many there are below the corner.
  [[nodiscard]] std::uint64_t rank(std::uint64_t corner) const {
    const std::size_t word = corner / kBits;
    std::uint64_t rank = before_[word / kStep];
    for (std::size_t i = word / kStep * kStep; i < word; ++i) {
      rank += static_cast<std::uint64_t>(std::popcount(words_[i]));
    }
    return rank + static_cast<std::uint64_t>(std::popcount(words_[word] & (bit(corner) - 1)));
  }

 private:
  static constexpr std::size_t kBits = 64, kStep = 16;

  static std::uint64_t bit(std::uint64_t corner) { return std::uint64_t{1} << corner % kBits; }

  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> before_;  // every kStep words
  std::uint64_t count_ = 0;
};

}  // namespace dupin::tiles
