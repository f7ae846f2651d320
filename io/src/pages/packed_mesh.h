#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::pages {

/// A mesh for a page: few bytes, looked at and not computed with.
struct PackedMesh {
  std::size_t points = 0, triangles = 0;
  Vec3 center = Vec3::Zero();  ///< coordinates are relative to it
  double step = 1;  ///< and multiples of this power of two, the 2^23rd of the box or less
  /// How many triangles of which label follow each other: sorted by label, else as in the mesh.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  /// Numbers of variable length, seven bits to a byte, the lowest first, the eighth set if more
  /// follow. Of each point, numbered as triangles come to it, the differences of its coordinates
  /// from the last one's: 2 d, or -2 d - 1 if negative. Then of each corner how much less than the
  /// number of points so far its point is: 0 is the next new one. (After Rossignac: Edgebreaker,
  /// the idea that neighbours have near numbers, alone.)
  std::string bytes;
};

/// Points that no triangle uses are left out. O(n).
[[nodiscard]] PackedMesh packed(const TriMesh& mesh);

}  // namespace dupin::pages
