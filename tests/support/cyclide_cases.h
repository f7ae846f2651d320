#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_chain.h"

namespace dupin::test {

inline PeVector sphere(double x, double y, double z, double r) { return {Vec3(x, y, z), r}; }

/// The PE-unit direction along `axis` with sine of the half angle `sine`.
inline PeVector direction(const Vec3& axis, double sine) {
  const double slope = sine / std::sqrt(1 - sine * sine);
  return {std::hypot(1, slope) * axis.normalized(), slope};
}

/// The crane hook of [SD94].
inline std::vector<PeVector> crane_hook_spheres() {
  return {sphere(0, 8, 0, .55),       sphere(0, 6, 0, .58),      sphere(0, 4.2, 0, .62),
          sphere(.3, 3.3, 0, .70),    sphere(1, 2.6, 0, .78),    sphere(1.75, 1.95, 0, .87),
          sphere(2, 1, 0, .95),       sphere(1.4, -.4, 0, 1.0),  sphere(0, -1, 0, 1.05),
          sphere(-1.75, .05, 0, .85), sphere(-1.9, 1.7, 0, .60), sphere(-1.9, 2.2, 0, .43),
          sphere(-2, 2.7, 0, .25)};
}

inline CyclideChain crane_hook() { return compose(crane_hook_spheres(), {Vec3(0, -1, 0), 0}); }

/// The same with all after the sphere of index 6 turned by 25 degrees.
inline CyclideChain twisted_crane_hook() {
  return twist(crane_hook(), 3, 25 * std::numbers::pi / 180).chain;
}

/// The jet engine of [SD94].
inline CyclideChain jet_engine() {
  const std::vector<PeVector> spheres{sphere(0, 0, 0, 1.00),   sphere(1.1, 0, 0, 1.25),
                                      sphere(2.4, 0, 0, 1.35), sphere(3.7, 0, 0, 1.30),
                                      sphere(5.0, 0, 0, 1.10), sphere(6.4, 0, 0, .85),
                                      sphere(7.6, 0, 0, .62)};
  return compose(spheres, direction(Vec3::UnitX(), 0.3));
}

/// Two pieces with a lune between them (mathematics C9).
inline std::vector<PeVector> lune_spheres() {
  return {sphere(0, 0, 0, 1), sphere(2, 1, 0, .8), sphere(4, 1, 0, 1), sphere(6, .2, 0, .9),
          sphere(8, 1, 0, .7)};
}

/// Balls of radius 1 along a line of length 4 to the origin and one of length 4 from there, at an
/// angle to it.
inline std::vector<PeVector> corner_spheres(double bend) {
  const Vec3 on(std::cos(bend), std::sin(bend), 0);
  return {sphere(-4, 0, 0, 1), sphere(-2, 0, 0, 1), {Vec3::Zero(), 1}, {2 * on, 1}, {4 * on, 1}};
}

/// A cylinder along the x axis to the origin, then a cone whose balls grow by `sine` of the way.
inline std::vector<PeVector> cylinder_to_cone_spheres(double sine, double bend) {
  std::vector<PeVector> spheres = corner_spheres(bend);
  spheres[3].r += 2 * sine;
  spheres[4].r += 4 * sine;
  return spheres;
}

/// Regular pieces between random spheres in [-4, 4]^3.
struct RandomArcs {
  std::mt19937_64 random{1994};
  std::uniform_real_distribution<double> place{-4, 4}, radius{0.3, 1.2}, sine{-0.4, 0.4};

  Vec3 vector() { return {place(random), place(random), place(random)}; }
  PeArc next() {
    for (;;) {
      const PeVector a{vector(), radius(random)}, b{vector(), radius(random)};
      const PeVector t = direction(vector(), sine(random));
      if (validity(a, t, b).fault == ArcFault::none) {
        return PeArc::from(a, t, b);
      }
    }
  }
};

}  // namespace dupin::test
