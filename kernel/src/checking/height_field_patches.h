#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

/// Patches of a surface that are graphs of height over a plane of coordinates, and so do not meet
/// themselves: the lemma that spares `check` and rounding most pairs of triangles.
///
/// Lemma. Take triangles that, seen along an axis of coordinates, all turn the same way, and the
/// edges that they run through more often one way than the other: the border. Over a place in
/// general position lie as many of the triangles as the border winds about it. If the border's
/// edges meet in common ends only, and bound a region to their left, then it winds about every
/// place once or not at all. So no two of the triangles lie over each other, and two can meet only
/// where both end: in a corner or an edge that is the same for both.
///
/// The turns are certain by a filter (stable_side_of_line), the border is tested exactly, in the
/// plane (projected_contours.h). The contour test is that of [VM94], who look at normals within a
/// half-space instead of turns.
namespace dupin::checking {

/// A partition of triangles, or of some of them, into patches.
struct HeightFieldPatches {
  std::vector<std::uint32_t> of_triangle;  ///< its patch, or support::kNone
  std::uint32_t count = 0;
  /// For each point 1 if all triangles around it are of one patch; not always then.
  std::vector<std::uint8_t> is_inner;
};

struct HeightFieldOptions {
  bool closed = false;  ///< promises that every edge is run through as often one way as the other;
                        ///< it saves work
  /// Per point 1 where that is not promised of its edges; empty if there are none such.
  std::span<const std::uint8_t> rim;
  /// The share of points whose triangles must all face the same way; else there are no patches. On
  /// rough surfaces it takes longer to prove them than to look at pairs of triangles.
  double smooth = 0;
  /// Patches are to be such wherever each coordinate of each point moves by at most this.
  double margin = 0;
};

/// Patches whose triangles certainly meet each other in nothing but corners and edges that they
/// share.
///
/// O(n) for the inside of patches, O(n log n) for their borders.
[[nodiscard]] HeightFieldPatches height_field_patches(std::span<const Vec3> points,
                                                      std::span<const Triangle> triangles,
                                                      const HeightFieldOptions& options = {});

}  // namespace dupin::checking
