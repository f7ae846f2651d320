#pragma once

#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin::meshing {

/// A mesh for solvers, and what was proved of it.
struct SolverMesh {
  VolumeMesh mesh;
  Solid surface;  ///< that of the mesh
  RemeshReport report;
};

/// As `remesh` says, and `fill`.
[[nodiscard]] SolverMesh make_solver_mesh(const Solid& solid, const RemeshOptions& options,
                                          bool fill);

}  // namespace dupin::meshing
