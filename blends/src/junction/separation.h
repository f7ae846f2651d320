#pragma once

#include <string>

#include "dupin/blends/junction.h"

// Junctions of any number of pipes: a hub sphere, and from every end a collar, the one piece of a
// cyclide that leaves along the pipe and ends in the hub, to which it is tangent. What is left of
// the hub is the sphere less one cap for each collar. collar.h has the closed forms, junction.cpp
// chooses the hub, hub_mesh.h triangulates it, and this file decides whether it all is embedded.
//
// Two caps are disjoint if and only if their circles' planes are; with the collars' end tangents
// T_i, T_j, scaled to the same length, this is <T_i, T_j> < -1, tau_i + tau_j > 0. A circle of a
// canal surface, at unit speed in R^{3,1}, misses the plane at height h = 0 if and only if h^2 -
// r^2 + (r' h - h' r)^2 > 0, with r the sphere's radius and h its centre's height: on an arc a
// quartic over a square, whose sign Bernstein coefficients tell.
namespace dupin::junction {

/// Exact, or on rounded numbers for searches.
enum class Arithmetic { exact, rounded };

/// Whether the caps of two arms have no point in common.
[[nodiscard]] bool caps_are_disjoint(const PeArc& a, const PeArc& b, Arithmetic arithmetic);

/// The angle between two caps, negative where they overlap.
[[nodiscard]] double cap_gap(const PeArc& a, const PeArc& b);

/// Whether the arms are proved to lie on different sides of a plane through the hub's centre.
[[nodiscard]] bool arms_are_apart(const JunctionArm& a, const JunctionArm& b,
                                  Arithmetic arithmetic);

/// Whether the collar stays before the plane of its start circle, as one that turns by less than
/// half a circle does.
[[nodiscard]] bool goes_forward(const PeArc& collar, Arithmetic arithmetic);

/// Whether the cone that ends where the collar begins comes nearer to the hub all the way.
[[nodiscard]] bool approaches(const PeArc& collar, Arithmetic arithmetic);

}  // namespace dupin::junction
