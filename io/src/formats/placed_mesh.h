#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/LU>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// No file unfolds to more points and triangles: parts can be repeated in parts, so that a few
/// lines may ask for any amount.
inline constexpr std::size_t kLargestUnfolding = 300'000'000;

/// Where a part of a file stands: point -> linear * point + shift.
struct Transform {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Transform after(const Transform& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
  [[nodiscard]] bool is_identity() const {
    return linear == Eigen::Matrix3d::Identity() && shift == Vec3::Zero();
  }
};

/// Appends points and triangles of a part at its place, turned inside out if it is mirrored, so
/// that its outside stays outside. False if a coordinate is beyond the range of doubles.
inline bool append_placed(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                          const Transform& place, TriMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  const bool plain = place.is_identity();
  const bool mirrored = place.linear.determinant() < 0;
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

/// The name of what our writers of 3MF and glTF, which have no place for it, put there for a mesh
/// without triangles, as operations may give it. In any other file that shows no triangle something
/// is missing.
inline constexpr char kEmptySet[] = "empty set";

}  // namespace dupin::formats
