#include "text/point_merger.h"

#include <bit>
#include <limits>

namespace dupin::text {
namespace {

constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();

/// Multiply and fold, with the constants of splitmix64: all bits of all coordinates reach the low
/// bits.
std::size_t hash(const Vec3& point) {
  std::uint64_t bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    bits = (bits ^ std::bit_cast<std::uint64_t>(point[axis])) * 0xbf58476d1ce4e5b9U;
    bits ^= bits >> 32;
  }
  bits *= 0x94d049bb133111ebU;
  return bits ^ (bits >> 29);
}

}  // namespace

PointMerger::PointMerger(std::size_t expected) {
  points_.reserve(expected);
  slots_.assign(std::bit_ceil(2 * expected + 16), kEmpty);
}

std::uint32_t PointMerger::index_of(const Vec3& point) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(point) & mask;
  while (slots_[slot] != kEmpty) {
    if (points_[slots_[slot]] == point) {
      return slots_[slot];
    }
    slot = (slot + 1) & mask;
  }
  const auto index = static_cast<std::uint32_t>(points_.size());
  slots_[slot] = index;
  points_.push_back(point);
  if (2 * points_.size() > slots_.size()) {
    grow();
  }
  return index;
}

void PointMerger::grow() {
  slots_.assign(2 * slots_.size(), kEmpty);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::size_t slot = hash(points_[i]) & mask;
    while (slots_[slot] != kEmpty) {
      slot = (slot + 1) & mask;
    }
    slots_[slot] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace dupin::text
