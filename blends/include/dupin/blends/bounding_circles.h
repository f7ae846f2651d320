#pragma once

#include <array>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/pe_arc.h"

namespace dupin {

/// A circle in the plane of symmetry of a piece that touches all of its spheres. The radius is
/// positive where the circle encloses them, negative where it lies outside of them.
struct BoundingCircle {
  Vec3 center = Vec3::Zero();
  double radius = 1;
};

/// The two circles in which the plane of symmetry meets the piece's surface, on the side of
/// frame(arc).first first; of a piece of revolution, in the plane of that frame. Of regular
/// elliptic pieces one encloses the spheres, of hyperbolic ones both or neither.
///
/// Throws Error{invalid_argument} where one is a line.
[[nodiscard]] std::array<BoundingCircle, 2> bounding_circles(const PeArc& arc);

/// The cyclide with these bounding circles in a plane of this unit normal: `elliptic` if the
/// radii differ by more than the centres, `hyperbolic` otherwise. Throws Error{invalid_argument}
/// unless one of both differs.
[[nodiscard]] CanonicalCyclide canonical_form(const BoundingCircle& one,
                                              const BoundingCircle& other,
                                              const Vec3& plane_normal);

}  // namespace dupin
