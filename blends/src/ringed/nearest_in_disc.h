#pragma once

#include "dupin/kernel/vec.h"

namespace dupin::ringed {

/// The point nearest to `point` of the disc that a Ring or TravelRing bounds.
template <class Circle>
[[nodiscard]] Vec3 nearest_in_disc(const Circle& disc, const Vec3& point) {
  const Vec3 off = point - disc.center;
  const Vec3 flat = off - off.dot(disc.normal) * disc.normal;
  const double length = flat.norm();
  return disc.center + (length > disc.radius ? disc.radius / length : 1) * flat;
}

}  // namespace dupin::ringed
