#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// A port: the circle in which a part ends. Stored by both neighbours and never recomputed, so that
/// they share it bitwise.
struct Ring {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, pointing out of the part
  double radius = 1;            ///< positive
  double slope = 0;  ///< dR/ds along `normal`: the tangent of the half angle of the cone it ends, 0
                     ///< for a cylinder

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

/// `ring` seen from the neighbour: the same circle, normal and slope negated.
[[nodiscard]] Ring flipped(const Ring& ring);

/// Throws Error{invalid_argument} unless all numbers are finite, the radius positive, and the
/// normal of unit length to 1e-9.
void validate(const Ring& ring);

/// A unit vector orthogonal to the ring's normal (to rounding), the same for `ring` and
/// `flipped(ring)`, bitwise.
[[nodiscard]] Vec3 reference_axis(const Ring& ring);

/// The regular polygon inscribed in `ring` before snapping, counter-clockwise about its normal,
/// starting at `reference_axis(ring)` turned by the phase.
///
/// `sample(flipped(r), s)` is the same point set, bitwise, in reverse order (index 0 stays): two
/// parts that share a ring share its vertices. Requires a valid ring and at least 3 segments;
/// throws Error{invalid_argument} otherwise.
[[nodiscard]] std::vector<Vec3> sample(const Ring& ring, const RingSampling& sampling);

/// `point` moved to the nearest multiple of `grid` per coordinate, ties to even; unchanged for grid
/// 0. The move is at most sqrt(3)/2 grid.
[[nodiscard]] Vec3 snapped(const Vec3& point, double grid);

}  // namespace dupin
