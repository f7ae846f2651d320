#pragma once

#include <optional>
#include <vector>

#include <gmpxx.h>

#include "dupin/blends/spine.h"
#include "numbers/exact_vec3.h"

// What surfaces run along: a spine y(t), a law of radii R(t) and a frame that turns no more than it
// must, all for t in [0, 1], ' being d/dt. Spines are cubics from end points and end velocities
// [MS06] eq. (2), lines, arcs and (rational) Bezier curves, among them the intersection of two
// cones [BWL17]; R is constant, linear, cubic or the radius along a Dupin cyclide [MS06] eq. (6);
// frames are rotation-minimising [WJZL08]. All are public values, in dupin/blends/spine.h,
// radius_law.h and frame.h, evaluated in doubles. Here and in exact_radius.h the same curves are
// exact polynomials of the stored numbers, which is what regularity is decided by.
namespace dupin::curves {

/// A unit normal of the plane that the spine lies in, decided exactly from its coefficients; any
/// normal for a straight spine, none for a spatial one.
[[nodiscard]] std::optional<Vec3> plane_normal(const Spine& spine);

/// The coefficients of y'(t), lowest power first, exactly those of the stored numbers.
[[nodiscard]] std::vector<numbers::ExactVec3> velocity(const LineSpine& line);
[[nodiscard]] std::vector<numbers::ExactVec3> velocity(const HermiteSpine& hermite);

/// y'(t) of a rational curve, as numerator / weight^2.
struct RationalVelocity {
  std::vector<numbers::ExactVec3> numerator;
  std::vector<mpq_class> weight;
};

[[nodiscard]] RationalVelocity velocity(const BezierSpine& bezier);

}  // namespace dupin::curves
