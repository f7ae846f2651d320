#include <cstdint>
#include <vector>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/interior_point.h"
#include "dupin/kernel/patch.h"
#include "mesh/point_winding.h"
#include "support/sequences.h"

namespace dupin {

int winding_number(const TriMesh& mesh, const Vec3& point) {
  validate(mesh);
  if (!point.allFinite()) {
    throw Error(Errc::invalid_argument,
                "a surface winds about points of finite coordinates only, not " + decimal(point));
  }
  return mesh::winding_number({mesh.points, mesh.triangles},
                              support::numbers_below(mesh.triangles.size()),
                              {exact::exact_vector(point), 1, Eigen::AlignedBox3d(point, point)});
}

}  // namespace dupin
