#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "support/hash.h"
#include "support/none.h"

namespace dupin::support {

/// Numbers distinct keys of two words in order of first appearance.
class KeyNumbering {
 public:
  struct Key {
    std::uint64_t first, second;
    friend bool operator==(const Key&, const Key&) = default;
  };

  explicit KeyNumbering(std::size_t expected_count)
      : slots_(std::bit_ceil(2 * expected_count + 16), kNone) {
    keys_.reserve(expected_count);
  }

  /// The number of `key`; equal to the former size() if it is new.
  std::uint32_t number(const Key& key) {
    if (2 * keys_.size() >= slots_.size()) {
      grow();
    }
    std::size_t i = hash(key) & (slots_.size() - 1);
    for (; slots_[i] != kNone; i = (i + 1) & (slots_.size() - 1)) {
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
  static std::size_t hash(const Key& key) {
    return static_cast<std::size_t>(mixed(mixed(0, key.first), key.second));
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::uint32_t k = 0; k < size(); ++k) {
      std::size_t i = hash(keys_[k]) & (slots_.size() - 1);
      while (slots_[i] != kNone) {
        i = (i + 1) & (slots_.size() - 1);
      }
      slots_[i] = k;
    }
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Key> keys_;
};

}  // namespace dupin::support
