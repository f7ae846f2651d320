#pragma once

#include "meshing/given_solid.h"
#include "meshing/solver_mesh_maker.h"

namespace dupin::meshing {

/// The surface of a mesh for solvers. Points along curves come first; then each region has a mesh
/// of its own, side by side, that ends at them: what lies behind a thin wall does not matter to it.
/// The meshes fit, and that together they are a solid is proved in the end. Where something cannot
/// be proved, shorter lengths are tried for the regions at fault and those beside them.
[[nodiscard]] SolverMesh make_surface_mesh(const GivenSolid& given);

}  // namespace dupin::meshing
