#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

/// Angles of meshes for solvers, by other means than the kernel's.
namespace dupin::test {

inline constexpr double kDegree = M_PI / 180;

inline double smallest_angle(const TriMesh& mesh) {
  double least = M_PI;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p[] = {mesh.points[a], mesh.points[b], mesh.points[c]};
    for (int i = 0; i < 3; ++i) {
      const Vec3 u = p[(i + 1) % 3] - p[i], v = p[(i + 2) % 3] - p[i];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return least;
}

}  // namespace dupin::test
