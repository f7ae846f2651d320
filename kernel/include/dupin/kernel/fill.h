#pragma once

#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin {

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
