#pragma once

#include <array>
#include <variant>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// The straight segment from + t (to - from).
struct LineSpine {
  Vec3 from, to;
  friend bool operator==(const LineSpine&, const LineSpine&) = default;
};

/// The circular arc through `start` about the line (center, axis), turning right-handed by `angle`
/// > 0 radians.
struct ArcSpine {
  Vec3 center, axis, start;  ///< axis is unit and orthogonal to start - center (to rounding)
  double angle = 0;
  friend bool operator==(const ArcSpine&, const ArcSpine&) = default;
};

/// The cubic Hermite curve of [MS06] eq. (2) with the design's correction E1: end points and end
/// velocities (k a2, l a3).
struct HermiteSpine {
  Vec3 from, to, start_velocity, end_velocity;
  friend bool operator==(const HermiteSpine&, const HermiteSpine&) = default;
};

/// A Bezier curve of any degree, rational if it has weights. Needs at least 2 points, and no
/// weights or one positive weight per point.
struct BezierSpine {
  std::vector<Vec3> points;
  std::vector<double> weights = {};
  friend bool operator==(const BezierSpine&, const BezierSpine&) = default;
};

/// The curve that the centres of a ringed surface's circles run along, for t in [0, 1].
using Spine = std::variant<LineSpine, ArcSpine, HermiteSpine, BezierSpine>;

/// A spine's position and derivatives with respect to t.
struct SpinePoint {
  Vec3 position, first, second, third;
};

[[nodiscard]] SpinePoint evaluate(const Spine& spine, double t);

/// Degree 5 with end points, end velocities, and vanishing second derivatives: curvature zero at
/// both ends.
[[nodiscard]] BezierSpine quintic_spine(const HermiteSpine& ends);

/// Degree 7 with end points, end velocities, and vanishing second and third derivatives: curvature
/// and its derivative zero at both ends.
[[nodiscard]] BezierSpine septic_spine(const HermiteSpine& ends);

/// Curvature |y' x y''| / |y'|^3 at a spine point; requires a non-zero velocity.
[[nodiscard]] double curvature(const SpinePoint& point);

/// The curve besides the line V0 V3 in which two quadratic cones meet [BWL17] Theorem 1: the first
/// has its apex at V0 and the ridge V1 V2 V3 with weights m, the second its apex at V3 and the
/// ridge V0 V1 V2 with weights w. It is the rational cubic Bezier curve with control points V0 to
/// V3, so it leaves along V0 V1 and arrives along V2 V3.
///
/// Throws Error{invalid_argument} unless the points are finite and the weights positive.
[[nodiscard]] BezierSpine two_cone_spine(const std::array<Vec3, 4>& vertices,
                                         const std::array<double, 3>& m,
                                         const std::array<double, 3>& w);

}  // namespace dupin
