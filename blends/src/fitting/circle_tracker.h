#pragma once

#include "dupin/blends/ringed_fit.h"

// This folder: surfaces that are given as f = 0, and ringed ones in their place ([mathematics
// A11]): circles on the surface, one after the other (circle_tracker.h), and blends from one to the
// next (ringed_fit.h).

namespace dupin::fitting {

/// A circle on, or nearly on, an implicit surface, and how it moves along it.
struct TrackedCircle {
  MovingRing ring;    ///< its centre at unit speed
  double defect = 0;  ///< the largest |f| / |gradient| of its points
};

/// The circle nearest to `guess` whose centre lies in the plane through the guess' centre across
/// `along`: Gauss-Newton on the mean of the squared first-order distances of 24 points. Throws
/// Error{infeasible_blend} if that does not converge.
[[nodiscard]] TrackedCircle circle_near(const ImplicitSurface& surface, const TravelRing& guess,
                                        const Vec3& along);

/// Throws Error{invalid_argument} where one of the two functions is none.
void require_functions(const ImplicitSurface& surface);

/// |f| / |gradient|; infinite where the gradient vanishes, or is not finite.
[[nodiscard]] double first_order_distance(const ImplicitSurface& surface, const Vec3& point);

}  // namespace dupin::fitting
