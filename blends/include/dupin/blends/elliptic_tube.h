#pragma once

#include <optional>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// A port whose rim is an ellipse (or a circle, where both radii agree).
struct EllipticRing {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();   ///< unit, pointing out of the part
  Vec3 axis = Vec3::UnitX();     ///< unit, orthogonal to the normal: the direction of `first`
  double first = 1, second = 1;  ///< semi-axes along `axis` and across it
  friend bool operator==(const EllipticRing&, const EllipticRing&) = default;
};

/// The same rim seen from the neighbour.
[[nodiscard]] EllipticRing flipped(const EllipticRing& ring);

/// Ellipses with semi-axes first(t), second(t) along a spine, in its normal planes. Their axes turn
/// by `turn` radians in all against the rotation-minimising frame that starts at start.axis, eased
/// so that they do not turn at the ends.
struct EllipticTube {
  EllipticRing start, end;  ///< stored, shared with the neighbours bitwise
  Spine spine;
  RadiusLaw first, second;
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

/// A tube between elliptic cylinders, tangent (G1) or of equal curvature (G2) all around, which the
/// Frenet frame of [BWL17] is not. options.k, l and margin act as for cyclic_blend of the circles
/// about the ellipses; radius_law applies to each semi-axis. Of the two ways to turn the axes (they
/// are lines, not arrows) the shorter is taken; circles do not turn.
///
/// Throws as cyclic_blend, and Error{invalid_argument} for axes that are not unit and orthogonal to
/// their normals (to 1e-9).
[[nodiscard]] EllipticTube elliptic_blend(const EllipticRing& from, const EllipticRing& to,
                                          const CyclicBlendOptions& options = {});

}  // namespace dupin
