#pragma once

#include "dupin/blends/end.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A rational ringed surface between ports: oblique cylinders and cones, and what blends them.
struct RationalRingedTube {
  Ring start, end;  ///< stored, shared with the neighbours bitwise
  RationalRingedSurface surface;
};

/// The cylinder, or cone, oblique or right, of circles in planes orthogonal to `normal` between two
/// centres. Throws Error{invalid_argument} for bad numbers and a normal not within 90 degrees of
/// the direction of travel.
[[nodiscard]] RationalRingedTube oblique_tube(const Vec3& from, const Vec3& to, const Vec3& normal,
                                              double start_radius, double end_radius);

/// The same of circles parallel to `start`, whose normal points out of the tube.
[[nodiscard]] RationalRingedTube oblique_tube(const Ring& start, const Vec3& to, double end_radius);

/// How the tube's ring moves as it leaves the tube through that end, at unit speed.
[[nodiscard]] MovingRing leaving(const RationalRingedTube& tube, End end);

/// The same motion backwards: the normal and all rates but the normal's change sign.
[[nodiscard]] MovingRing reversed(const MovingRing& ring);

/// The same motion at another speed.
[[nodiscard]] MovingRing at_speed(const MovingRing& ring, double factor);

}  // namespace dupin
