#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::checking {

/// A partition of triangles, or of some of them, into patches.
struct HeightFieldPatches {
  std::vector<std::uint32_t> of_triangle;  ///< its patch, or kNone
  std::uint32_t count = 0;
  /// For each point 1 if all triangles around it are of one patch; not always then.
  std::vector<std::uint8_t> is_inner;
  static constexpr std::uint32_t kNone = 0xffffffff;
};

struct HeightFieldOptions {
  bool closed = false;  ///< promises that every edge is run through as often one way as the other;
                        ///< it saves work
  /// The share of points whose triangles must all face the same way; else there are no patches. On
  /// rough surfaces it takes longer to prove them than to look at pairs of triangles.
  double smooth = 0;
  /// HeightFieldPatches are to be such wherever each coordinate of each point moves by at most
  /// this.
  double margin = 0;
};

/// HeightFieldPatches whose triangles certainly meet each other in nothing but corners and edges
/// that they share: seen along an axis of coordinates, the patch is monotone. All its triangles
/// turn the same way, and the edges at which it ends make simple closed curves, apart from each
/// other, that wind about every place once or not at all. As many triangles lie over a place as the
/// curves wind about it; so no two lie over each other.
///
/// O(n) for the inside of patches, O(n log n) for their borders.
[[nodiscard]] HeightFieldPatches height_field_patches(std::span<const Vec3> points,
                                                      std::span<const Triangle> triangles,
                                                      const HeightFieldOptions& options = {});

}  // namespace dupin::checking
