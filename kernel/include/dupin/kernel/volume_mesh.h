#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// Four indices into the points of a mesh; the last three are seen counter-clockwise from the side
/// away from the first, so that the volume is positive.
using Tetrahedron = std::array<std::uint32_t, 4>;

/// A solid cut into tetrahedra that share corners, edges and triangles, and nothing else.
struct VolumeMesh {
  /// The triangles that bound it, with its labels. Their corners are the first of its points.
  TriMesh surface;
  std::vector<Vec3> inner_points;  ///< numbered on from those of the surface
  std::vector<Tetrahedron> tetrahedra;

  [[nodiscard]] std::size_t point_count() const {
    return surface.points.size() + inner_points.size();
  }
  [[nodiscard]] const Vec3& point(std::uint32_t index) const {
    return index < surface.points.size() ? surface.points[index]
                                         : inner_points[index - surface.points.size()];
  }
};

/// One of triangles and tetrahedra that share the points of `surface`: those of triangles come
/// first, then those of tetrahedra alone, each in their order, and others are left out. O(n).
[[nodiscard]] VolumeMesh volume_mesh_of(TriMesh surface, std::vector<Tetrahedron> tetrahedra);

}  // namespace dupin
