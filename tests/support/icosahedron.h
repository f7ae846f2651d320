#pragma once

#include <numbers>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::test {

/// The corners of a regular icosahedron about the origin, with edges of length 2.
inline std::vector<Vec3> icosahedron_corners() {
  const double golden = std::numbers::phi;
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-golden, golden}) {
        Vec3 corner = Vec3::Zero();
        corner(axis) = a;
        corner((axis + 1) % 3) = b;
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

}  // namespace dupin::test
