#pragma once

#include <array>
#include <vector>

#include "dupin/blends/end.h"
#include "dupin/blends/moving_ring.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// Circles of radius rho(t) about d(t), in planes orthogonal to n(t) = A i A*, all rational: d and
/// rho are Bezier cubics, A a quaternion Bezier curve of degree 1 or 3 [BL15]. Its tangent plane is
/// continued from any of the surfaces above.
struct RationalRingedSurface {
  std::array<Vec3, 4> center;                   ///< Bezier points of d
  std::array<double, 4> radius;                 ///< Bezier coefficients of rho
  std::vector<std::array<double, 4>> rotation;  ///< Bezier points (w, x, y, z) of A
};

/// x(t, v) with the closed-form normal, outward where the discs do not overlap.
[[nodiscard]] SurfacePoint evaluate(const RationalRingedSurface& surface, double t, double v);

/// The ring at t with its rates.
[[nodiscard]] MovingRing ring_at(const RationalRingedSurface& surface, double t);

/// d'.n - rho |n'| (n unit): positive if and only if the discs near t do not overlap.
[[nodiscard]] double disc_margin(const RationalRingedSurface& surface, double t);

/// Whether rho > 0 and rho |n'| < (1 - margin) d'.n on [0, 1], decided by Bernstein subdivision of
/// the exact polynomials; false also where that does not decide within 40 halvings. At an end where
/// the circle stands still and its radius alone moves, as it does out of a plate, the inequality
/// holds in the limit. Throws Error{invalid_argument} for numbers that are not finite.
[[nodiscard]] bool proves_regular(const RationalRingedSurface& surface, double margin = 0);

/// The largest multiple of 1/256 that is a proven lower bound of min(1 - rho |n'| / d'.n), which
/// for normal ringed surfaces is min(1 - kappa R). 0 for what is regular, but barely.
[[nodiscard]] double certified_margin(const RationalRingedSurface& surface);

[[nodiscard]] double area(const RationalRingedSurface& surface);
/// Swept by the discs.
[[nodiscard]] double volume(const RationalRingedSurface& surface);

/// A rational Bezier patch exactly: net[i][j] holds (x w, y w, z w, w), i along, j around.
struct RationalPatch {
  std::vector<std::array<std::array<double, 4>, 3>> net;
};

/// The part of the surface between the angles v0 < v1 < v0 + pi.
[[nodiscard]] RationalPatch rational_patch(const RationalRingedSurface& surface, double v0,
                                           double v1);

/// A patch's point; t along and s around, both in [0, 1].
[[nodiscard]] Vec3 evaluate(const RationalPatch& patch, double t, double s);

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
