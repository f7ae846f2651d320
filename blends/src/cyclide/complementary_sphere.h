#pragma once

#include "dupin/blends/pe_arc.h"

namespace dupin::cyclide {

/// A sphere of the second family, homogeneous: centre center / weight, signed radius radius /
/// weight; weight 0 is a plane.
struct ComplementarySphere {
  Vec3 center;
  double radius = 0, weight = 0;
};

/// The sphere of the second family that touches the piece along the line of curvature of ring
/// coordinates (kappa, c, s), which are (1, cos v, sin v) for a point of the start circle. Bilinear
/// in the ring coordinates and the data of the arc.
[[nodiscard]] ComplementarySphere complementary_sphere(const PeArc& arc, const ArcFrame& frame,
                                                       double kappa, double c, double s);

}  // namespace dupin::cyclide
