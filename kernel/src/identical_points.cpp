#include "identical_points.h"

#include <algorithm>
#include <bit>

namespace dupin::detail {

std::uint64_t hash_of(const Vec3& point) {
  std::uint64_t mixed = 0;
  for (const double coordinate : {point.x(), point.y(), point.z()}) {
    // Adding 0.0 turns -0.0 into 0.0. The multiplier is 2^64 over the golden ratio, made odd.
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9e3779b97f4a7c15;
    mixed ^= mixed >> 32;
  }
  return mixed;
}

std::vector<std::uint32_t> first_identical(std::span<const Vec3> points) {
  constexpr std::uint32_t kFree = 0xffffffff;
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(slots, kFree);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hash_of(points[i]) & (slots - 1);
    while (table[slot] != kFree && points[table[slot]] != points[i]) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == kFree) {
      table[slot] = i;
    }
    first[i] = table[slot];
  }
  return first;
}

}  // namespace dupin::detail
