#include "dupin/kernel/remesh.h"

#include <utility>

#include "dupin/kernel/parallel.h"
#include "meshing/solver_mesh_maker.h"

namespace dupin {

Remeshed remesh(const Solid& solid, const RemeshOptions& options) {
  const UsualArithmetic usual;
  meshing::SolverMesh made = meshing::make_solver_mesh(solid, options, false);
  return {made.surface, std::move(made.report)};
}

}  // namespace dupin
