#pragma once

#include <cstdint>

namespace dupin::support {

/// A hash with one more word mixed in; it starts at 0. For tables whose size is a power of two: the
/// low bits depend on all bits of the word, the high ones too.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio, made odd
  hash = (hash ^ hash >> 32) * 0xbf58476d1ce4e5b9;
  return hash ^ hash >> 32;
}

}  // namespace dupin::support
