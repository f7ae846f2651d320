#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// What makes a ring an ellipse: `Ring::radius` and `Ring::slope` are those of the semi-axis along
/// `axis`, these are those of the semi-axis across it.
struct Ellipse {
  Vec3 axis = Vec3::UnitX();  ///< unit, orthogonal to the ring's normal
  double across = 1;          ///< positive
  double across_slope = 0;
  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

/// A port: the circle, or ellipse, in which a part ends. Stored by both neighbours and never
/// recomputed, so that they share it bitwise.
struct Ring {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, pointing out of the part
  double radius = 1;            ///< positive
  double slope = 0;  ///< dR/ds along `normal`: the tangent of the half angle of the cone it ends, 0
                     ///< for a cylinder
  std::optional<Ellipse> ellipse = {};  ///< none: a circle

  friend bool operator==(const Ring&, const Ring&) = default;
};

/// How rings become polygons. One value per connected run of parts, so that shared rings share
/// their vertices.
struct RingSampling {
  std::uint32_t segments = 64;  ///< at least 3
  double phase = 0;             ///< starting angle, in segments, about the ring's axis
  double grid =
      0;  ///< spacing of the lattice the points are snapped to (a power of two), or 0 for none
};

/// `ring` seen from the neighbour: the same curve, normal and slopes negated.
[[nodiscard]] Ring flipped(const Ring& ring);

/// The semi-axis across the one that `radius` is of: a circle's radius again.
[[nodiscard]] double across(const Ring& ring);

/// The slope of that semi-axis.
[[nodiscard]] double across_slope(const Ring& ring);

/// The larger of both semi-axes.
[[nodiscard]] double largest_radius(const Ring& ring);

/// What no point of either of two circles is further from the other than, but for rounding.
[[nodiscard]] double circle_distance(const Ring& a, const Ring& b);

/// Throws Error{invalid_argument} unless all numbers are finite, radii positive, and the normal and
/// an ellipse's axis of unit length and orthogonal to 1e-9.
void validate(const Ring& ring);

/// A unit vector orthogonal to the ring's normal (to rounding), the same for `ring` and
/// `flipped(ring)`, bitwise: an ellipse's axis.
[[nodiscard]] Vec3 reference_axis(const Ring& ring);

/// The polygon inscribed in `ring` before snapping, counter-clockwise about its normal, starting at
/// `reference_axis(ring)` turned by the phase: regular, or for an ellipse at equal steps of the
/// parameter u of cos u radius axis + sin u across (normal x axis).
///
/// `sample(flipped(r), s)` is the same point set, bitwise, in reverse order (index 0 stays): two
/// parts that share a ring share its vertices. Requires a valid ring, at least 3 segments, and a
/// phase and a grid that are finite; throws Error{invalid_argument} otherwise.
[[nodiscard]] std::vector<Vec3> sample(const Ring& ring, const RingSampling& sampling);

/// `point` moved to the nearest multiple of `grid` per coordinate, ties to even; unchanged for grid
/// 0. The move is at most sqrt(3)/2 grid.
[[nodiscard]] Vec3 snapped(const Vec3& point, double grid);

}  // namespace dupin
