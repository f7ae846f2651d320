#include <cstdint>
#include <numeric>
#include <vector>

#include "dupin/kernel/interior_point.h"
#include "mesh/point_winding.h"

namespace dupin {

int winding_number(const TriMesh& mesh, const Vec3& point) {
  std::vector<std::uint32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  return mesh::winding_number({mesh.points, mesh.triangles}, faces,
                              {exact::exact_vector(point), 1, Eigen::AlignedBox3d(point, point)});
}

}  // namespace dupin
