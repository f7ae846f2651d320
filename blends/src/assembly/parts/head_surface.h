#pragma once

#include <variant>

#include "dupin/blends/part_surface.h"

namespace dupin::assembly {

/// Half an ellipsoid of revolution; the other semi-axes are the radius of the ring that it begins
/// at.
struct EllipsoidProfile {
  double depth = 1;
};

/// A crown of a sphere and a knuckle of a torus, tangent to each other and to the cylinder of the
/// ring. Radii; the knuckle's is less than the ring's, the crown's larger.
struct TorisphereProfile {
  double crown = 1, knuckle = 1;
};

using HeadProfile = std::variant<EllipsoidProfile, TorisphereProfile>;

/// Of the radius: how far the polynomials that stand for profiles are off these, at most.
inline constexpr double kHeadDeviation = 1e-10;

/// The head that goes on from `start`, whose normal points out of it, as a chain of ringed surfaces
/// about its axis. It ends in a flat disc of 1/256 of the radius: of a head twice as wide as deep
/// that is 4e-6 of the radius below the true tip. Profiles are polynomials within
/// kHeadDeviation.
[[nodiscard]] PartSurface head_surface(const Ring& start, const HeadProfile& profile);

/// What a wall leaves of it: a head whose radii, and whose depth, are less by the wall. That of a
/// torisphere is parallel to it. Throws Error{infeasible_blend} if it leaves nothing.
[[nodiscard]] PartSurface inner_head(const Ring& start, const HeadProfile& profile, double wall);

}  // namespace dupin::assembly
