#pragma once

#include <cmath>

#include "dupin/blends/ringed_surface.h"

namespace dupin::test {

/// The axis of the second pipe in Figs 5 and 6 of [MS06].
inline Vec3 skew_axis() { return Vec3(1, 2, 10) / std::sqrt(105.0); }

/// The skew spine of Figs 5 and 6 with end speeds k and l.
inline HermiteSpine skew_spine(double k, double l) {
  return {Vec3(0, 0, 0), Vec3(10, 4, 0), Vec3(k, 0, 0), l * skew_axis()};
}

inline RingedSurface ringed(const HermiteSpine& spine, double r0, double r1,
                            const RadiusLaw& radius) {
  return {{spine.from, -spine.start_velocity.normalized(), r0},
          {spine.to, spine.end_velocity.normalized(), r1},
          spine,
          radius};
}

inline RingedSurface figure5(const RadiusLaw& radius = CubicRadius{1, 2}) {
  return ringed(skew_spine(18, 25), 1, 2, radius);
}

inline RingedSurface figure6(const RadiusLaw& radius = CubicRadius{1, 2}) {
  return ringed(skew_spine(10, 20), 1, 2, radius);
}

/// Figs 3 and 4 of [MS06]: a straight reducer of length 6 from radius 1 to 9 with k = l.
inline RingedSurface straight_reducer(double speed, const RadiusLaw& radius) {
  return ringed({Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(speed, 0, 0), Vec3(speed, 0, 0)}, 1, 9, radius);
}

/// The U-bend that stands in for Figs 7 and 8: half a ring cyclide's ports, 2 sqrt(57.25) apart.
inline RingedSurface u_bend(const RadiusLaw& radius) {
  return ringed({Vec3(0, 0, 0), Vec3(0, 2 * std::sqrt(57.25), 0), Vec3(30, 0, 0), Vec3(-30, 0, 0)},
                2, 4, radius);
}

}  // namespace dupin::test
