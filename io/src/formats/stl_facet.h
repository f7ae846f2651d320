#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// The unit normal as STL wants it beside each triangle, for readers that look at it; 0 for a
/// triangle without one.
inline Eigen::Vector3f facet_normal(const Triangle& triangle, const std::vector<Vec3>& points) {
  const Vec3& origin = points[triangle[0]];
  const Vec3 area = (points[triangle[1]] - origin).cross(points[triangle[2]] - origin);
  const double length = area.norm();
  const Vec3 normal = length > 0 ? Vec3(area / length) : Vec3::Zero();
  return (normal.array() + 0.0).cast<float>();  // -0 becomes 0
}

}  // namespace dupin::formats
