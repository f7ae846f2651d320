#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"

// The ringed blends of the mathematics' tables.
namespace dupin::test {

// An oblique cone into a cylinder.
inline RationalRingedSurface cone_to_cylinder() {
  return ringed_blend(along_oblique_cone({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, Vec3(.6, 0, -3), 1.2),
                      along_canal({Vec3(4, 1, 3.5), Vec3::UnitX(), .8}, 0, 3.5));
}

inline CanalEnd start_cone() { return {{Vec3(0, 0, 0), Vec3::UnitZ(), 1}, .25, 5}; }
inline CanalEnd end_cone() { return {{Vec3(5, 1, 1), Vec3(.8, 0, -.6), .6}, -.15, 5}; }

inline RationalRingedSurface general_ends() {
  const Vec3 normal = Vec3(1, 1, .2).normalized();
  const MovingRing from{Vec3(0, 0, 0), Vec3::UnitZ(), 1, Vec3(.5, .2, 4), -.6, Vec3(.4, -.1, 0)};
  const MovingRing to{Vec3(3, 4, 3),
                      normal,
                      1.1,
                      4 * normal + Vec3(0, .3, -.2),
                      .8,
                      .3 * normal.cross(Vec3::UnitZ())};
  return ringed_blend(from, to);
}

// Of 401 samples, as tabulated.
inline double least_margin(const RationalRingedSurface& surface) {
  double least = disc_margin(surface, 0);
  for (int i = 1; i <= 400; ++i) {
    least = std::min(least, disc_margin(surface, i / 400.));
  }
  return least;
}

}  // namespace dupin::test
