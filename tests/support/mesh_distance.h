#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

/// Distances by brute force, by other means than the product's.
namespace dupin::test {

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const Vec3 corners[] = {a, b, c};
  bool inside = true;
  double nearest = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &q = corners[i], edge = corners[(i + 1) % 3] - q;
    inside = inside && normal.dot(edge.cross(p - q)) >= 0;
    const double t = std::clamp(edge.dot(p - q) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (q + t * edge - p).norm());
  }
  return inside ? std::abs(normal.dot(p - a)) : nearest;
}

inline double distance_to(const Vec3& p, const TriMesh& mesh) {
  double nearest = INFINITY;
  for (const auto& [a, b, c] : mesh.triangles) {
    nearest =
        std::min(nearest, distance_to_triangle(p, mesh.points[a], mesh.points[b], mesh.points[c]));
  }
  return nearest;
}

/// The largest distance of seeded random points of one mesh from the other.
inline double sampled_distance(const TriMesh& from, const TriMesh& to) {
  constexpr int kSamples = 400;
  std::mt19937 random(29);
  std::uniform_real_distribution<double> unit(0, 1);
  double largest = 0;
  for (int i = 0; i < kSamples; ++i) {
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
