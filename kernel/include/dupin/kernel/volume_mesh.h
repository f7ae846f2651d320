#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "dupin/kernel/tetrahedron.h"

namespace dupin {

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

struct Filled {
  VolumeMesh mesh;
  RemeshReport report;
  double smallest_dihedral_angle = 0;  ///< of the tetrahedra, in radians
};

/// A mesh of tetrahedra for what a solid encloses, for solvers: its surface is as `remesh` makes
/// it, with the same options, report and errors; circumradii are at most half the longest edge
/// allowed, and as far as the surface allows at most twice the shortest edge. By CGAL's Mesh_3,
/// with exact predicates; all tetrahedra are looked at again, exactly.
[[nodiscard]] Filled fill(const Solid& solid, const RemeshOptions& options);

}  // namespace dupin
