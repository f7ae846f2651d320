#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

/// What tests of meshes for solvers measure by other means than the kernel's.
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

inline double distance_to(const Vec3& p, const TriMesh& mesh) {
  double nearest = INFINITY;
  for (const auto& [i, k, l] : mesh.triangles) {
    const Vec3 corners[] = {mesh.points[i], mesh.points[k], mesh.points[l]};
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    bool inside = true;
    for (int j = 0; j < 3; ++j) {
      const Vec3 &q = corners[j], edge = corners[(j + 1) % 3] - q;
      inside = inside && normal.dot(edge.cross(p - q)) >= 0;
      const double t = std::clamp(edge.dot(p - q) / edge.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (q + t * edge - p).norm());
    }
    nearest = inside ? std::min(nearest, std::abs(normal.dot(p - corners[0]))) : nearest;
  }
  return nearest;
}

/// The largest distance of seeded random points of one mesh from the other.
inline double sampled_distance(const TriMesh& from, const TriMesh& to) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> unit(0, 1);
  double largest = 0;
  for (int i = 0; i < 300; ++i) {
    const Triangle& t = from.triangles[random() % from.triangles.size()];
    const double r = std::sqrt(unit(random)), s = unit(random);
    largest = std::max(largest,
                       distance_to((1 - r) * from.points[t[0]] + r * (1 - s) * from.points[t[1]] +
                                       r * s * from.points[t[2]],
                                   to));
  }
  return largest;
}

}  // namespace dupin::test
