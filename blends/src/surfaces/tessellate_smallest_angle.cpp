#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"

namespace dupin {

double smallest_angle(const TriMesh& mesh) {
  double smallest = std::numbers::pi;
  for (const auto& triangle : mesh.triangles) {
    if (std::ranges::max(triangle) >= mesh.points.size()) {
      throw Error(Errc::invalid_argument, "a triangle has the corner " +
                                              std::to_string(std::ranges::max(triangle)) + " of " +
                                              std::to_string(mesh.points.size()) + " points");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& at = mesh.points[triangle.at(i)];
      const Vec3 u = mesh.points[triangle.at((i + 1) % 3)] - at;
      const Vec3 v = mesh.points[triangle.at((i + 2) % 3)] - at;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return smallest;
}

}  // namespace dupin
