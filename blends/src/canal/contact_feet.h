#pragma once

#include <array>
#include <vector>

#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin::canal {

/// Of the ball's radius, by the way that its centre moves; its absolute value is less than 1.
/// Throws Error{irregular_surface} where it is not: the ball envelops nothing there.
[[nodiscard]] double radius_lag(const MovingBall& ball);

/// The outward unit normal of the quadric, told as in `contact_arc`, where the ball touches it:
/// away from the sphere inside the quadric that touches it there too. Throws
/// Error{invalid_argument} for elliptic rings.
[[nodiscard]] Vec3 normal_at_foot(const Ring& quadric, const MovingBall& ball);

/// Where the ball touches them: the feet of `contact_arc`, in a third of its time. Throws as it
/// does.
[[nodiscard]] std::array<Vec3, 2> contact_feet(const std::array<Ring, 2>& quadrics,
                                               const MovingBall& ball);

/// The same of so many balls of a loop, evenly by the parameter from 0 on: the feet on each
/// quadric.
[[nodiscard]] std::array<std::vector<Vec3>, 2> sampled_feet(const CanalFillet& loop, int samples);

}  // namespace dupin::canal
