#pragma once

#include <array>

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

}  // namespace dupin
