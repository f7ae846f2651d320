#pragma once

#include "dupin/kernel/vec.h"

namespace dupin::tessellation {

[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether the segments from a to b and from c to d cross inside of both, as doubles see it.
[[nodiscard]] inline bool cross_inside(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
         cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

}  // namespace dupin::tessellation
