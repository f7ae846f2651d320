#pragma once

#include <functional>
#include <optional>
#include <string>

#include "dupin/blends/cyclic_blend.h"

namespace dupin::ringed {

/// Radii at both ends of a blend, with their slopes along the normals that point into it.
struct EndRadii {
  double start = 1, start_slope = 0, end = 1, end_slope = 0;
};

/// The law that joins the radii along a spine that cyclic_blend gave for these options.
[[nodiscard]] RadiusLaw blend_radius(const EndRadii& radii, const Spine& spine,
                                     const CyclicBlendOptions& options);

/// What is wrong with a blend whose end speeds are to be proposed, in words that follow "the
/// blend"; none where nothing is.
using BlendFault = std::function<std::optional<std::string>(const RingedSurface&)>;

/// cyclic_blend, where a circle about an elliptic end stands for it: with the larger semi-axis and
/// the larger slope, so that its discs hold those between the ellipses. Speeds are proposed with
/// which it has none of these faults, either, or the fault is named.
[[nodiscard]] RingedSurface surrounding_blend(const Ring& from, const Ring& to,
                                              const CyclicBlendOptions& options,
                                              const BlendFault& also = {});

}  // namespace dupin::ringed
