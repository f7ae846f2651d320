#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::checking {

/// What spares a search for meeting triangles most of its pairs.
struct DisjointFaceGroups {
  /// Per triangle a group, or support::kNone: those of one group certainly meet each other in
  /// nothing but corners and edges that they share, and have an area.
  std::vector<std::uint32_t> of_face;
  std::vector<std::uint32_t> injective_stars;  ///< per point; see injective_stars()
};

/// A mesh, and the same triangles with the first of identical points for corners: the very same if
/// there are no such points.
struct WeldedMesh {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles, corners;
  std::span<const std::uint32_t> representatives;  ///< the first of identical points, per point

  [[nodiscard]] bool has_identical_points() const { return triangles.data() != corners.data(); }
};

/// By height field patches, where the surface is smooth, and by injective stars; `closed`, `margin`
/// and `rim` are those of HeightFieldOptions.
[[nodiscard]] DisjointFaceGroups proven_groups(const WeldedMesh& mesh, bool closed, double margin,
                                               std::span<const std::uint8_t> rim = {});

/// The groups given, and injective stars where triangles have none.
[[nodiscard]] DisjointFaceGroups given_groups(const WeldedMesh& mesh,
                                              std::span<const std::uint32_t> given);

}  // namespace dupin::checking
