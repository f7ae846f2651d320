#pragma once

#include <algorithm>

#include "dupin/kernel/vec.h"

namespace dupin::numbers {

/// Points by x, then y, then z: for tables in which only a bitwise equal point is the same.
struct PointOrder {
  [[nodiscard]] bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

}  // namespace dupin::numbers
