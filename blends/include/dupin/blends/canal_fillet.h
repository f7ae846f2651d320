#pragma once

#include <array>
#include <variant>
#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/blends/regularity.h"
#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A ball that rolls, and its motion at one parameter; lengths in the unit of the assembly,
/// derivatives by the parameter.
struct MovingBall {
  Vec3 center = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< m, m', m''
  double radius = 1, radius_rate = 0, radius_acceleration = 0;  ///< rho > 0, rho', rho''
};

/// Where a ball touches two cylinders or cones from outside, and the shorter arc between both
/// places of the circle along which it touches the envelope of its motion. [KK00] section 2.
struct ContactArc {
  std::array<Vec3, 2> feet;     ///< P1, P2, on the first and the second quadric
  std::array<Vec3, 2> normals;  ///< of the quadrics there, outward, unit
  Vec3 center = Vec3::Zero();   ///< of the circle, which is orthogonal to the velocity
  double radius = 1;
  Vec3 to_first = Vec3::UnitX();  ///< unit, from the centre to P1
  Vec3 across = Vec3::UnitY();    ///< unit, in the circle's plane, orthogonal to `to_first`, on the
                                  ///< side of P2
  double angle = 0;               ///< of the arc, in [0, pi); 0 where the feet coincide
  /// Where the tangents at the feet meet, and its weight in the rational arc with weights 1, w, w:
  /// the squared cosine of half the angle.
  Vec3 middle = Vec3::Zero();
  double weight = 1;
};

/// The arc of the ball between the quadrics. Each quadric is told by a ring of it: the axis is the
/// line through its centre along its normal, the slope is that of the radius along it (0: a
/// cylinder). Of a cone it is the nappe where the radius is positive. The ball is taken to touch
/// both from outside; what is found lies on both then, up to rounding.
///
/// Throws Error{invalid_argument} for elliptic rings, Error{irregular_surface} where the ball grows
/// at least as fast as it moves: it envelops nothing then.
[[nodiscard]] ContactArc contact_arc(const std::array<Ring, 2>& quadrics, const MovingBall& ball);

/// The point at an angle from the first foot: feet[0] at 0, feet[1] at arc.angle.
[[nodiscard]] Vec3 point(const ContactArc& arc, double angle);

/// How far the envelope is from folding along the arc: the least
/// 1 - (rho'^2 + rho (m''.n + rho'')) / |m'|^2, n being the unit vector from the ball's centre.
/// The area element is this times |m'| rho by the parameter and the angle; the envelope is regular
/// along the arc if and only if it is positive.
[[nodiscard]] double least_regularity(const MovingBall& ball, const ContactArc& arc);

/// Balls of one radius on two cylinders of which the thinner passes through the thicker: the
/// parameter is the angle around the thinner one. Their centres are
/// origin + x along + side y across + z up, with z = d sin - height,
/// y = sqrt((below + d (1 - sin)) (above + d (1 + sin))), x = (d cos + side y cosine) / sine.
struct RollingThrough {
  Vec3 origin = Vec3::Zero();  ///< of the thicker cylinder's axis, nearest to the other axis
  /// Orthonormal: the thicker axis, what the thinner axis has across it, and their product.
  Vec3 along = Vec3::UnitX(), across = Vec3::UnitY(), up = Vec3::UnitZ();
  double cosine = 0, sine = 1;  ///< of the angle between the axes, sine > 0
  double distance = 1;          ///< d: of the centres from the thinner axis
  double height = 0;            ///< of the thicker axis over the thinner one
  double below = 0, above = 0;  ///< difference of the radii plus and minus the height, >= 0
  double side = 1;              ///< 1 or -1
  double radius = 1;
};

/// The same where neither passes through the other, with w = d1 + d2 - height, z = w sin^2 - d1,
/// y = sqrt(w) sin sqrt(first + w cos^2), x = (sqrt(w) cos sqrt(second + w sin^2) + y cosine) /
/// sine.
struct RollingPartly {
  Vec3 origin = Vec3::Zero();  ///< of the upper axis, nearest to the other axis
  Vec3 along = Vec3::UnitX(), across = Vec3::UnitY(), up = Vec3::UnitZ();
  double cosine = 0, sine = 1;
  double distance = 1;           ///< d1: of the centres from the upper axis
  double overlap = 1;            ///< w > 0
  double first = 1, second = 1;  ///< d1 - d2 + height and d2 - d1 + height, > 0
  double radius = 1;
};

/// Balls of one radius on two quadrics, one of them a cone at least, of which the second passes
/// through the first: the parameter is the angle around the second. Each quadric's parallel one at
/// the distance of the radius is told by a ring; the centre is where the generator of the second
/// meets the first, on the side to which the second one's normal points or the other one.
struct RollingOnCones {
  Ring first, second;  ///< of the centres: at the ring's centre, along its normal, with its radius
  Vec3 zero = Vec3::UnitX(), quarter = Vec3::UnitY();  ///< directions of the second one's angles
  double side = 1;                                     ///< 1 or -1
  double radius = 1;
};

/// The same where neither passes through the other: generators of the second, those at the angles
/// 2 atan(width cos), meet the first at (sin sqrt(rest[0] + rest[1] cos + ...) - b) / a.
struct RollingPartlyOnCones {
  Ring first, second;
  Vec3 zero = Vec3::UnitX(), quarter = Vec3::UnitY();
  std::array<double, 7> rest{1};  ///< of a polynomial that is positive between -1 and 1
  double width = 1, radius = 1;
};

/// Balls of varying radius on two quadrics of which the second passes through the first, rational
/// in the tangent of half the parameter: [KK00] as corrected in the mathematics B.5. The balls are
/// the points of R^{3,1} (centre; -radius)
/// origin + x along + y across + (2 p d / n) e3 - (d (1 + p^2) / n) e4, with
/// y = side d (1 - p^2) / n, x = (2 g d cos / n + y cosine) / sine, p = g sin, n = 1 + p^2 - 2 g,
/// g = size[0] + size[1] cos + size[2] sin + size[3] cos of the double parameter.
struct RationalCrossing {
  PeVector origin, along, across, e3, e4;  ///< the latter four PE-orthonormal, e4 timelike
  double cosine = 0, sine = 1;  ///< of the angle between the directions in R^{3,1}, sine > 0
  double distance = 1;          ///< d
  double side = 1;              ///< 1 or -1
  std::array<double, 4> size{};
};

/// The same where the span of both directions is timelike, as for two quadrics with parallel axes
/// that are not both cylinders; the loop surrounds the first one (mathematics B.6):
/// origin + h u v ey + 4 h c / ((1 - a)(1 + b)) ez + x nu1 + y nu2, with a = a0^2 (1 + cos) / 2,
/// b = b0^2 (1 - cos) / 2, c = a0 b0 sin / 2, u = (1 + a) / (1 - a), v = (1 - b) / (1 + b), and x,
/// y such that the products with nu1 and nu2 are h (u - v) and h (u + v).
struct RationalParallel {
  PeVector origin, ey, ez, nu1, nu2;
  double half_distance = 1;                      ///< h
  double product = -2;                           ///< <nu1, nu2> < -1
  double far_squared = 0.5, near_squared = 0.5;  ///< a0^2 in (0, 1), b0^2: set radii at 0 and pi
};

/// Balls that touch two cylinders or cones, one loop of them, with the period 2 pi. Value type.
struct CanalFillet {
  std::array<Ring, 2> quadrics;  ///< as they were given, in that order
  std::variant<RollingThrough, RollingPartly, RollingOnCones, RollingPartlyOnCones,
               RationalCrossing, RationalParallel>
      motion;
};

/// The ball and its motion at a parameter. At a corner (`corners`) the derivatives are one-sided:
/// those of the side on which the rounded parameter lies.
[[nodiscard]] MovingBall ball(const CanalFillet& fillet, double parameter);

/// An upper bound of |m''| + |rho''| over a stretch, by interval arithmetic; infinite where none is
/// found. A corner may be an end of the stretch, not inside of it.
[[nodiscard]] double acceleration_bound(const CanalFillet& fillet, const ParameterInterval& at);

/// The parameters in (-pi, pi] where the loop has a corner: the feet coincide there, where one
/// cylinder touches the other from inside (at one place), or both are equally thick and their axes
/// meet (at pi/2 and -pi/2). Both loops have their corners in the same places.
[[nodiscard]] std::vector<double> corners(const CanalFillet& fillet);

/// The fillets of a ball of constant radius between two quadrics, which it touches from outside
/// (mathematics B.7). Two where one quadric passes through the other, or touches it from inside, or
/// both are equally thick cylinders and meet: first the one on the side to which the ring normal of
/// the quadric that passes points; of cylinders the thinner one passes, of equal ones the second.
/// One where neither passes, or where a cone opens wider than it turns from the other's axis. Gaps
/// up to `touching` of the size are none: the ball misses the cylinders by so much then. With the
/// radius 0 the loops are the curves in which they cross.
///
/// Throws Error{invalid_argument} for invalid or elliptic rings and numbers that are negative;
/// Error{irregular_surface} where the ball closes no such loop: the axes are parallel, the quadrics
/// do not meet, or a cone and another quadric touch. A loop that folds is not refused:
/// `prove_regular` tells.
[[nodiscard]] std::vector<CanalFillet> rolling_ball_fillets(const std::array<Ring, 2>& quadrics,
                                                            double radius,
                                                            double touching = 0x1p-48);

/// The rational fillet on one side (1: the one to which the ring normal of the quadric that passes
/// points; -1) with these ball radii at the parameters 0, pi/2, pi and 3 pi/2, between two quadrics
/// of which one passes through the other, or that have parallel axes and are not both cylinders.
/// Of the latter there is one loop, around the first, whatever the side, and only the radii at 0
/// (far from the second one's axis) and pi (near it) count.
///
/// Throws Error{invalid_argument} for invalid or elliptic rings, radii that are not positive, and
/// other sides; Error{irregular_surface} where there is no such fillet, with why: neither quadric
/// passes through the other, both are cylinders with parallel axes, the radii are too large, or the
/// fillet would fold (at 128 parameters; `prove_regular` proves that it does not).
[[nodiscard]] CanalFillet rational_fillet(const std::array<Ring, 2>& quadrics,
                                          const std::array<double, 4>& radii, int side);

/// All of them with one radius at the four parameters: sides 1 and -1, or the one loop.
[[nodiscard]] std::vector<CanalFillet> rational_fillets(const std::array<Ring, 2>& quadrics,
                                                        double radius);

/// What was proved of a whole loop in interval arithmetic, of the stored numbers.
struct CanalRegularity {
  /// proved: `regularity` and `radius` are positive lower bounds of `least_regularity` and of the
  /// ball's radius. refuted: at `where` the fillet folds, or the ball's radius is not positive; the
  /// two are upper bounds there.
  Verdict verdict = Verdict::undecided;
  double regularity = 0, radius = 0;
  ParameterInterval where;  ///< refuted or undecided: where; else that of the lowest bound
  std::size_t leaves = 0;   ///< intervals on which the bounds were proved
};

/// By halving; the bound of the regularity is within a tenth of the true one, unless 4000
/// intervals do not suffice (mathematics D.4).
[[nodiscard]] CanalRegularity prove_regular(const CanalFillet& fillet);

}  // namespace dupin
