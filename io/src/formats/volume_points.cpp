#include "formats/volume_points.h"

#include <algorithm>
#include <string>

#include "dupin/kernel/error.h"
#include "text/mesh_text.h"

namespace dupin::formats {

std::vector<Vec3> writable_points(const VolumeMesh& mesh) {
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    if (const std::uint32_t last = std::ranges::max(tetrahedron); last >= mesh.point_count()) {
      throw Error(Errc::invalid_argument, "a tetrahedron has the point " + std::to_string(last) +
                                              " of " + std::to_string(mesh.point_count()));
    }
  }
  std::vector<Vec3> points = text::writable_points(mesh.surface, Coordinates::binary64);
  const std::vector<Vec3> inner =
      text::writable_points({mesh.inner_points, {}, {}, {}}, Coordinates::binary64);
  points.insert(points.end(), inner.begin(), inner.end());
  return points;
}

}  // namespace dupin::formats
