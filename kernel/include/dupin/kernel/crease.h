#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// A unit vector as files hold it: binary32, of length 1 to rounding.
using Direction = std::array<float, 3>;

/// One direction for each corner of each triangle of a mesh, in the order of the triangles; empty
/// where nothing is known of the surface that the mesh stands for.
using CornerNormals = std::vector<std::array<Direction, 3>>;

/// An edge of a mesh in which the surface turns.
struct Crease {
  std::array<std::uint32_t, 2> points{};
  std::array<std::uint32_t, 2> triangles{};  ///< at the edge; the lowest two where there are more
  Vec3 outward = Vec3::UnitZ();              ///< unit, between the triangles' normals
};

/// The edges whose triangles' normals enclose more than `angle`, in radians, and carry labels for
/// which `divides` holds, asked with the lower one first; edges of the same label, and all of a
/// mesh that is not labelled, never count. Edges of four triangles and more do if two labels of
/// theirs divide. In the order of their points. O(n log n). Throws as `require_indices`, and
/// Error{invalid_argument} for an angle that is not finite.
[[nodiscard]] std::vector<Crease> creases_between_labels(
    const TriMesh& mesh, double angle,
    const std::function<bool(std::uint32_t, std::uint32_t)>& divides);

}  // namespace dupin
