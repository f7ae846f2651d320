#include "dupin/kernel/error.h"
#include "dupin/kernel/solver_mesh.h"
#include "meshing/delaunay_refinement.h"

// A build without the generator.
namespace dupin {

bool has_mesh_generator() { return false; }

namespace meshing {

namespace {

[[noreturn]] void refuse() {
  throw Error(Errc::invalid_argument,
              "this build makes no meshes for solvers; build with DUPIN_MESHING=ON");
}

}  // namespace

Tetrahedra refine(const TriMesh&, const Features&, const Refinement&, const Progress&) { refuse(); }

Tetrahedra refine_surface(const TriMesh&, const Features&, const CurvePoints&, const Refinement&,
                          const Progress&) {
  refuse();
}

}  // namespace meshing
}  // namespace dupin
