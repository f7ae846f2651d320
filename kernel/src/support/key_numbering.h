#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace dupin::support {

/// Numbers distinct keys of two words in order of first appearance.
class KeyNumbering {
 public:
  struct Key {
    std::uint64_t first, second;
    friend bool operator==(const Key&, const Key&) = default;
  };

  explicit KeyNumbering(std::size_t expected_count)
      : slots_(std::bit_ceil(2 * expected_count + 16), kEmpty) {
    keys_.reserve(expected_count);
  }

  /// The number of `key`; equal to the former size() if it is new.
  std::uint32_t number(const Key& key) {
    if (2 * keys_.size() >= slots_.size()) {
      grow();
    }
    std::size_t i = hash(key) & (slots_.size() - 1);
    for (; slots_[i] != kEmpty; i = (i + 1) & (slots_.size() - 1)) {
      if (keys_[slots_[i]] == key) {
        return slots_[i];
      }
    }
    slots_[i] = size();
    keys_.push_back(key);
    return size() - 1;
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(keys_.size()); }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffff;

  static std::size_t hash(const Key& key) {
    std::uint64_t h = (key.first * 0x9E3779B97F4A7C15u) ^ (key.second * 0xC2B2AE3D27D4EB4Fu);
    h = (h ^ (h >> 31)) * 0xBF58476D1CE4E5B9u;
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (std::uint32_t k = 0; k < size(); ++k) {
      std::size_t i = hash(keys_[k]) & (slots_.size() - 1);
      while (slots_[i] != kEmpty) {
        i = (i + 1) & (slots_.size() - 1);
      }
      slots_[i] = k;
    }
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Key> keys_;
};

}  // namespace dupin::support
