#pragma once

#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::healing {

/// How many copies of a triangle there are: with its corners in ascending order, or the other way.
struct CopyNumbers {
  int even = 0, odd = 0;
};

/// How often a triangle may count, and what it counts as it is.
struct CountRange {
  int given = 0, least = 0, most = 0;  ///< the last two of the size
};

/// For each triangle, all different and their corners ascending, how often it counts in a closed
/// surface; negative if the other way round. See settle_copies().
[[nodiscard]] std::vector<int> closing_counts(std::span<const Vec3> points,
                                              std::span<const Triangle> triangles,
                                              std::span<const CopyNumbers> numbers);

}  // namespace dupin::healing
