#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

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
  friend bool operator==(const Transform& a, const Transform& b) {
    return a.linear == b.linear && a.shift == b.shift;
  }
  [[nodiscard]] bool is_identity() const {
    return linear == Eigen::Matrix3d::Identity() && shift == Vec3::Zero();
  }
};

/// Whether it mirrors, exactly: its determinant is negative.
[[nodiscard]] bool mirrors(const Eigen::Matrix3d& linear);

/// Appends points and triangles of a part at its place, turned inside out if it is mirrored, so
/// that its outside stays outside. False if a coordinate is beyond the range of doubles.
[[nodiscard]] bool append_placed(const std::vector<Vec3>& points,
                                 const std::vector<Triangle>& triangles, const Transform& place,
                                 TriMesh& mesh);

/// The name of what our writers of 3MF and glTF, which have no place for it, put there for a mesh
/// without triangles, as operations may give it. In any other file that shows no triangle something
/// is missing.
inline constexpr char kEmptySet[] = "empty set";

}  // namespace dupin::formats
