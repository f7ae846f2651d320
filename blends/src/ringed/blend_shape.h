#pragma once

#include "dupin/blends/cyclic_blend.h"

namespace dupin::ringed {

/// Radii at both ends of a blend, with their slopes along the normals that point into it.
struct EndRadii {
  double start = 1, start_slope = 0, end = 1, end_slope = 0;
};

/// The law that joins the radii along a spine that cyclic_blend gave for these options.
[[nodiscard]] RadiusLaw blend_radius(const EndRadii& radii, const Spine& spine,
                                     const CyclicBlendOptions& options);

/// cyclic_blend, where a circle about an elliptic end stands for it: with the larger semi-axis and
/// the larger slope, so that its discs hold those between the ellipses.
[[nodiscard]] RingedSurface surrounding_blend(const Ring& from, const Ring& to,
                                              const CyclicBlendOptions& options);

}  // namespace dupin::ringed
