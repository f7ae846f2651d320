#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// A mesh for solvers, and what was proved of it.
struct SolverMesh {
  Tetrahedra mesh;
  Solid surface;  ///< of the triangles, with the points that they have, in their order
  std::vector<std::uint32_t> position;  ///< of each point there; support::kNone inside
  RemeshReport report;
};

/// Throws Error{invalid_argument} for what is outside its range.
void check_options(const RemeshOptions& options);

/// As `remesh` says, and `fill`, of a solid that is not empty.
[[nodiscard]] SolverMesh make_solver_mesh(const Solid& solid, const RemeshOptions& options,
                                          bool fill);

}  // namespace dupin::meshing
