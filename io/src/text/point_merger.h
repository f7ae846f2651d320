#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::text {

/// Gives equal points the same index, in order of first appearance: an open-addressing hash on the
/// bits of the coordinates. Points must be finite and without -0.
class PointMerger {
 public:
  /// `expected` distinct points fit without growing.
  explicit PointMerger(std::size_t expected);

  std::uint32_t index_of(const Vec3& point);

  [[nodiscard]] std::vector<Vec3> take_points() && { return std::move(points_); }

 private:
  void grow();

  std::vector<Vec3> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace dupin::text
