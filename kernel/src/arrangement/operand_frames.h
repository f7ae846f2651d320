#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "arrangement/input.h"

namespace dupin::arrangement {

using Bounds = Eigen::AlignedBox3d;
using Axes = Eigen::Matrix3d;  ///< unit rows, orthogonal to within rounding

/// axes * point, the quick way.
[[nodiscard]] inline Vec3 rotated(const Axes& axes, const Vec3& point) {
  return {axes.row(0).dot(point), axes.row(1).dot(point), axes.row(2).dot(point)};
}

/// An operand in a frame that fits it, with the boxes of runs of its triangles. Rotated coordinates
/// only cull; all boxes are inflated by more than rounding can amount to.
struct FramedOperand {
  static constexpr std::uint32_t kRun = 32;

  Axes axes = Axes::Identity();  ///< the longest extent first
  Bounds bounds;                 ///< in these axes
  std::vector<Bounds> runs;      ///< of triangles kRun i and on, in these axes
};

[[nodiscard]] FramedOperand framed(const mesh::ExactMesh& mesh, double slack);

/// How far rotated coordinates of points, themselves nearest doubles, can be off.
[[nodiscard]] double rotation_slack(double extent);

/// The bounds in `axes` of a box given in others.
[[nodiscard]] Bounds bounds_in(const Axes& axes, const Axes& others, const Bounds& box,
                               double slack);

/// Axes such that the first runs along the first of `a`, and the first of `b` in the plane of the
/// first two; those of `a` if both are nearly parallel.
[[nodiscard]] Axes common_axes(const Axes& a, const Axes& b);

}  // namespace dupin::arrangement
