#include "formats/placed_mesh.h"

#include <cstdint>

#include <gmpxx.h>

namespace dupin::formats {

// In doubles products of small scales underflow to 0, and nearly flat ones round to either sign.
bool mirrors(const Eigen::Matrix3d& linear) {
  const auto minor = [&](Eigen::Index i, Eigen::Index k) -> mpq_class {
    return mpq_class(linear(1, i)) * mpq_class(linear(2, k)) -
           mpq_class(linear(1, k)) * mpq_class(linear(2, i));
  };
  const mpq_class determinant = mpq_class(linear(0, 0)) * minor(1, 2) -
                                mpq_class(linear(0, 1)) * minor(0, 2) +
                                mpq_class(linear(0, 2)) * minor(0, 1);
  return sgn(determinant) < 0;
}

bool append_placed(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                   const Transform& place, TriMesh& mesh) {
  if (!place.linear.allFinite() || !place.shift.allFinite()) {
    return false;
  }
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  const bool plain = place.is_identity();
  const bool mirrored = !plain && mirrors(place.linear);
  bool finite = true;
  for (const Vec3& point : points) {
    const Vec3 placed = plain ? point : Vec3(place.linear * point + place.shift);
    finite = finite && placed.allFinite();
    mesh.points.emplace_back(placed.array() + 0.0);  // -0 becomes 0
  }
  for (const Triangle& t : triangles) {
    mesh.triangles.push_back(
        {first + t[0], first + t[mirrored ? 2 : 1], first + t[mirrored ? 1 : 2]});
  }
  return finite;
}

}  // namespace dupin::formats
