#pragma once

#include <cmath>

#include "dupin/kernel/vec.h"

namespace dupin::numbers {

/// Between two directions of any length, in [0, pi]; accurate for small and flat angles alike.
[[nodiscard]] inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace dupin::numbers
