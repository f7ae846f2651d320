#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "dupin/blends/rational_ringed_surface.h"

namespace dupin {

/// The surface f = 0, with f's gradient, which must not vanish on it.
struct ImplicitSurface {
  std::function<double(const Vec3&)> value;
  std::function<Vec3(const Vec3&)> gradient;
};

struct ImplicitContourOptions {
  double step = 0.1;  ///< between points, positive; they are nearer where the contour turns
  std::size_t most_points = 10'000;  ///< where a curve that does not close ends
};

/// The contour of an implicit surface for a direction, through the point that Newton's iteration
/// finds from `start`: f = 0 and the gradient is at right angles to the direction; traced along the
/// cross product of both functions' gradients (mathematics A10). A closed one ends with its first
/// point. Throws Error{invalid_argument} for bad numbers and empty functions,
/// Error{infeasible_blend} where the iteration does not converge, or the contour has no direction.
[[nodiscard]] std::vector<Vec3> implicit_contour(const ImplicitSurface& surface,
                                                 const Vec3& direction, const Vec3& start,
                                                 const ImplicitContourOptions& options = {});

/// Ringed surfaces in place of an implicitly given one.
struct RingedFit {
  std::vector<RationalRingedTube> pieces;  ///< tangent to each other, sharing their rings
  /// The largest |f| / |gradient| of 17 by 25 points of each piece: the distance to the implicit
  /// surface, to first order in itself. It is within the tolerance.
  double error = 0;
  /// The same of 24 points of each of the circles that were found: how far the surface is from
  /// being ringed at all. No fit can be better.
  double circularity_defect = 0;
};

/// The circles of an implicit surface are tracked from the one near `from` in the direction of its
/// normal, as the least squares of 24 points each, to the plane of `to`, and joined by ringed
/// blends, halved until they are within the tolerance (mathematics A11). Both rings' normals point
/// in the direction of travel.
///
/// Throws Error{invalid_argument} for bad numbers and empty functions, Error{infeasible_blend}
/// saying where and by how much, if the circularity defect exceeds the tolerance, the tracked
/// circles turn back or do not end at `to`, and Error{limit_exceeded} for more than 4096 pieces.
[[nodiscard]] RingedFit fit_ringed(const ImplicitSurface& surface, const Ring& from, const Ring& to,
                                   double tolerance);

}  // namespace dupin
