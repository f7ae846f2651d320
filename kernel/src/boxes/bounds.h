#pragma once

#include <span>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

namespace dupin::boxes {

/// The box around the points, along the coordinate axes; an empty one for none. Exact.
[[nodiscard]] inline Eigen::AlignedBox3d bounds_of(std::span<const Vec3> points) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : points) {
    bounds.extend(point);
  }
  return bounds;
}

}  // namespace dupin::boxes
