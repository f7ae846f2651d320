#pragma once

#include <cstdint>
#include <span>

#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// What the measurements and the topology read of a mesh, whoever owns it. Indices are in range.
struct MeshView {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;
  std::span<const ExactPoint> implicit = {};  ///< of the last points

  MeshView(std::span<const Vec3> all_points, std::span<const Triangle> all_triangles)
      : points(all_points), triangles(all_triangles) {}
  explicit MeshView(const ExactMesh& mesh)
      : points(mesh.points), triangles(mesh.triangles), implicit(mesh.implicit) {}

  [[nodiscard]] std::size_t double_count() const { return points.size() - implicit.size(); }
  [[nodiscard]] ExactPoint exact(std::uint32_t index) const {
    if (index >= double_count()) {
      return implicit[index - double_count()];
    }
    return {points[index].x(), points[index].y(), points[index].z(), 1};
  }
};

}  // namespace dupin::mesh
