#pragma once

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/blends/tangency.h"

namespace dupin {

/// Ellipses with semi-axes first(t), second(t) along a spine, in its normal planes. Their axes turn
/// by `turn` radians in all against the rotation-minimising frame that starts at `axis`, eased so
/// that they do not turn at the ends.
struct EllipticTube {
  Ring start, end;  ///< stored, shared with the neighbours bitwise; circles or ellipses
  Spine spine;
  RadiusLaw first, second;
  Vec3 axis = Vec3::UnitX();  ///< unit, across the spine: the direction of `first` at the start
  double turn = 0;
  Continuity continuity = Continuity::g1;  ///< how flatly the turn begins and ends
};

/// The frame field that `evaluate` takes.
[[nodiscard]] FrameField frames(const EllipticTube& tube, const FrameOptions& options = {});

/// x(t, u) = y + first cos u c1 + second sin u c2; u is the ellipse's parameter. The normal is
/// closed form, outward where the tube does not fold.
[[nodiscard]] SurfacePoint evaluate(const EllipticTube& tube, const FrameField& frames, double t,
                                    double u);

/// 1 - kappa times the ellipse's extent towards the centre of curvature: positive everywhere if and
/// only if the elliptic discs do not overlap locally.
[[nodiscard]] double margin_at(const EllipticTube& tube, const FrameField& frames, double t);

/// A proven lower bound of margin_at over [0, 1]: that of the circles about the ellipses.
[[nodiscard]] double certified_margin(const EllipticTube& tube);

/// pi times the integral of first second |y'|.
[[nodiscard]] double volume(const EllipticTube& tube);

/// An upper bound, in radians, of the angle between the tube's tangent planes at an end and those
/// of the ruled surface that its ring's slopes stand for, by interval arithmetic on the stored
/// numbers; 0 where slopes and rates vanish. It leaves out what rounding turned the ring's axes by.
[[nodiscard]] double tangency_bound(const EllipticTube& tube, End end);

/// A tube between elliptic (or circular) cylinders or cones, tangent (G1) or of equal curvature
/// (G2) all around, which the Frenet frame of [BWL17] is not. options.k, l and margin act as for
/// cyclic_blend of the circles about the ellipses; radius_law applies to each semi-axis. Of the two
/// ways to turn the axes (they are lines, not arrows) the shorter is taken; where an end is a
/// circle nothing turns.
///
/// Throws as cyclic_blend.
[[nodiscard]] EllipticTube elliptic_blend(const Ring& from, const Ring& to,
                                          const CyclicBlendOptions& options = {});

/// The tube about `spine` between the rings, with these laws of the semi-axes and the same choice
/// of axes.
[[nodiscard]] EllipticTube elliptic_tube(const Ring& start, const Ring& end, const Spine& spine,
                                         const RadiusLaw& first, const RadiusLaw& second,
                                         Continuity continuity = Continuity::g1);

}  // namespace dupin
