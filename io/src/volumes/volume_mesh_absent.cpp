#include "dupin/io/volume_mesh.h"
#include "dupin/kernel/error.h"

// A build without a generator.
namespace dupin {

bool has_volume_mesher() { return false; }

VolumeMesh fill_with_tetrahedra(const TriMesh& /*surface*/) {
  throw Error(Errc::invalid_argument,
              "this build makes no volume meshes; build it where gmsh's headers are (on Debian, "
              "apt-get install libgmsh-dev), with DUPIN_GMSH=ON");
}

}  // namespace dupin
