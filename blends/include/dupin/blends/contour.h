#pragma once

#include <vector>

#include "dupin/blends/part_surface.h"

namespace dupin {

/// A point of a surface whose unit normal, outward, is at right angles to the direction of view.
struct ContourPoint {
  Vec3 position, normal;
  /// Of the surface along the direction, by differences: positive where it curves away from the
  /// normal, as a ball does. Where it is negative the surface itself hides its contour.
  double curvature = 0;
};

/// Points along a contour, in order.
using ContourCurve = std::vector<ContourPoint>;

/// Where the surface's normals are at right angles to `direction`: what bounds its picture, and
/// where its front turns to its back ([MS06]; mathematics A10). Whether other surfaces, or other
/// places of its own, hide it is not asked. Segments of the polylines are within `tolerance` of the
/// curve. Loops smaller than a 32nd of the way around and along a piece may be missed; where a
/// whole region's normals are at right angles, as of a cylinder seen along its axis, there is none.
/// Throws Error{invalid_argument} for a direction that is zero or not finite and for a tolerance
/// that is not positive.
[[nodiscard]] std::vector<ContourCurve> contours(const PartSurface& surface, const Vec3& direction,
                                                 double tolerance);

}  // namespace dupin
