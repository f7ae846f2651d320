#pragma once

#include <array>

#include <gmpxx.h>

#include "dupin/kernel/vec.h"

namespace dupin::detail {

using RationalVector = std::array<mpq_class, 3>;

[[nodiscard]] inline RationalVector rational(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

[[nodiscard]] inline RationalVector difference(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline mpq_class dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace dupin::detail
