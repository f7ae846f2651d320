#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace dupin::boxes {

struct Box;

/// In the single precision coordinates of a BoxQuantizer; the latter by its corners.
using FramedPoint = Eigen::Vector3f;
using FramedTriangle = std::array<FramedPoint, 3>;

/// A box along axes of its own: long facets fill it, where they leave a Box empty. All coordinates
/// are at most 1, as a BoxQuantizer gives them.
class OrientedBox {
 public:
  OrientedBox() = default;
  explicit OrientedBox(const Box& box);
  /// Along the longest edge and in the plane of one of the triangles, which are not degenerate. At
  /// least one triangle.
  explicit OrientedBox(std::span<const FramedTriangle> triangles);
  /// Contains both, along the axes of the longer one.
  OrientedBox(const OrientedBox& a, const OrientedBox& b);

  /// True only if the boxes have no point in common; not always then.
  [[nodiscard]] bool apart(const OrientedBox& other) const;
  /// Makes the box contain the triangle too.
  void include(const FramedTriangle& triangle);
  /// A quarter of its surface.
  [[nodiscard]] float surface() const {
    return half_[0] * half_[1] + half_[1] * half_[2] + half_[2] * half_[0];
  }

 private:
  /// Ranges along the columns of `axes`.
  OrientedBox(const Eigen::Matrix3d& axes, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

  Eigen::Matrix3f axes_;  // columns, orthonormal but for rounding
  Eigen::Vector3f middle_, half_;
};

}  // namespace dupin::boxes
