#pragma once

#include <random>
#include <span>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::test {

/// Each coordinate of each point moved by the margin, less what rounding may add: up, down or, one
/// in three, anywhere between.
inline std::vector<Vec3> moved_points(std::span<const Vec3> points, double margin,
                                      std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<Vec3> moved(points.begin(), points.end());
  for (Vec3& point : moved) {
    for (double& x : point) {
      const double by = part(random);
      const double move = random() % 3 == 0 ? by : by < 0 ? -1 : 1;
      x += move * margin * (1 - 0x1p-20);
    }
  }
  return moved;
}

}  // namespace dupin::test
