#pragma once

#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// Upper bounds of angles between tangent planes, in radians.
struct Tangency {
  double start = 0, end = 0;
};

/// The largest angle, around each end, between the surface and the cylinder or cone that ends in
/// the ring there (its half angle is the ring's slope) [MS06]. Zero for a cyclic blend between
/// cylinders.
[[nodiscard]] Tangency tangency(const RingedSurface& surface);

}  // namespace dupin
