#include <cstdint>
#include <vector>

#include "dupin/kernel/interior_point.h"
#include "mesh/point_winding.h"
#include "support/sequences.h"

namespace dupin {

int winding_number(const TriMesh& mesh, const Vec3& point) {
  return mesh::winding_number({mesh.points, mesh.triangles},
                              support::numbers_below(mesh.triangles.size()),
                              {exact::exact_vector(point), 1, Eigen::AlignedBox3d(point, point)});
}

}  // namespace dupin
