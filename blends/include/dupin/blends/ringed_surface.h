#pragma once

#include "dupin/blends/frame.h"
#include "dupin/blends/radius_law.h"
#include "dupin/blends/spine.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A normal ringed (cyclic) surface: circles of radius R(t) about y(t), in the planes orthogonal to
/// y'(t) [MS06] eq. (1). Pipes, cones, elbows and cyclic blends are all of this kind.
///
/// `start` and `end` are the stored end rings, normals pointing out of the part: start.normal =
/// -T(0), end.normal = T(1). They are what neighbours share; the spine and law agree with them to
/// rounding, never the other way round.
struct RingedSurface {
  Ring start, end;
  Spine spine;
  RadiusLaw radius;
};

/// A point of a ringed surface with its partial derivatives by t and by the angle u.
struct SurfacePoint {
  Vec3 position, along, around;
  /// Unit, outward where 1 - kappa R > 0; closed form, independent of the frame [MS06].
  Vec3 normal;
};

/// x(t, u) = y(t) + R(t) (cos u first + sin u second) in the frame of `frames`, which must be a
/// frame field of the surface's spine. t in [0, 1], u in radians.
[[nodiscard]] SurfacePoint evaluate(const RingedSurface& surface, const FrameField& frames,
                                    double t, double u);

/// The lateral area, without end discs. Closed forms for cylinders and cones; else Gauss quadrature
/// along the spine and, unless the radius is constant, the periodic trapezoid rule around it;
/// relative error below 1e-12 for blends with a margin of 0.05.
[[nodiscard]] double area(const RingedSurface& surface);

/// The volume enclosed with the end discs, pi times the integral of R^2 |y'| [MS06]; signed where
/// the discs overlap. Relative error below 1e-14 for the same blends.
[[nodiscard]] double volume(const RingedSurface& surface);

/// The length of the spine, by the same quadrature.
[[nodiscard]] double length(const Spine& spine);

/// Suprema over a stretch of a ringed surface, in a rotation-minimising frame, of |x_tt|, |x_tu|
/// and |x_uu|: what decides how far a triangle is from the surface.
struct SecondDerivativeBounds {
  double along = 0, mixed = 0, around = 0;
};

/// Upper bounds over t in [from, to] within [0, 1], by interval arithmetic with outward rounding;
/// they converge to the suprema as the interval shrinks. Throws Error{irregular_surface} if the
/// spine may stop there.
[[nodiscard]] SecondDerivativeBounds second_derivative_bounds(const RingedSurface& surface,
                                                              double from, double to);

}  // namespace dupin
