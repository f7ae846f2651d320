#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "support/shapes.h"

namespace dupin::test {

/// Tetrahedra about one edge, apart from each other but for that.
inline TriMesh wedges(int count) {
  std::vector<TriMesh> all;
  for (int i = 0; i < count; ++i) {
    const double from = 2 * std::numbers::pi * i / count, to = from + std::numbers::pi / count;
    all.push_back({{Vec3(0, 0, 0), Vec3(0, 0, 1), 9 * Vec3(std::cos(from), std::sin(from), 0),
                    9 * Vec3(std::cos(to), std::sin(to), 0)},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  }
  return joined(all);
}

}  // namespace dupin::test
