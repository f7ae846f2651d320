#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// A closed surface of rings around a spine: a torus, through itself where the tube is thick.
inline TriMesh torus(std::uint32_t around, std::uint32_t along, double radius, double tube) {
  TriMesh mesh;
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double u = 2 * std::numbers::pi * i / along, v = 2 * std::numbers::pi * k / around;
      const double distance = radius + tube * std::cos(v);
      mesh.points.emplace_back(distance * std::cos(u), distance * std::sin(u), tube * std::sin(v));
      const std::uint32_t next = (k + 1) % around, ring = i * around,
                          other = (i + 1) % along * around;
      mesh.triangles.push_back({ring + k, other + k, other + next});
      mesh.triangles.push_back({ring + k, other + next, ring + next});
    }
  }
  return mesh;
}

/// Moves each point by up to `size` along each axis.
inline void shake(TriMesh& mesh, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> offset(-size, size);
  for (Vec3& p : mesh.points) {
    p += Vec3(offset(random), offset(random), offset(random));
  }
}

}  // namespace dupin::test
