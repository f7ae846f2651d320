#pragma once

#include <array>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

namespace dupin::arrangement {

/// Orthonormal coordinates in the plane of a triangle, within rounding.
class PlaneFrame {
 public:
  PlaneFrame(const Vec3& a, const Vec3& b, const Vec3& c)
      : origin_(a),
        first_((b - a).normalized()),
        second_(first_.cross(c - a).normalized().cross(first_)) {}

  [[nodiscard]] std::array<double, 2> at(const Vec3& point) const {
    return {(point - origin_).dot(first_), (point - origin_).dot(second_)};
  }

 private:
  Vec3 origin_, first_, second_;
};

}  // namespace dupin::arrangement
