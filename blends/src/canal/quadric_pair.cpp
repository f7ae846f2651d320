#include "canal/quadric_pair.h"

#include <cmath>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::canal {

void require_quadrics(const std::array<Ring, 2>& quadrics) {
  for (const Ring& quadric : quadrics) {
    validate(quadric);
    if (quadric.ellipse) {
      throw Error(Errc::invalid_argument, "a ball rolls on circular cylinders and cones only");
    }
  }
}

void require_positive(double ball_radius) {
  if (!(std::isfinite(ball_radius) && ball_radius > 0)) {
    throw Error(Errc::invalid_argument, "a ball's radius must be a positive number");
  }
}

QuadricPair quadric_pair(const std::array<Ring, 2>& quadrics) {
  constexpr double kParallel = 1e-12;  // of squared sines: of the angle 1e-6
  require_quadrics(quadrics);
  QuadricPair pair;
  pair.along = {contact_tangent(quadrics[0]), contact_tangent(quadrics[1])};
  const std::array<PeVector, 2> spheres{contact_sphere(quadrics[0]), contact_sphere(quadrics[1])};
  const auto& [f1, f2] = pair.along;
  pair.cosine = product(f1, f2);
  // 1 -+ cosine are half of these products.
  const PeVector less = f1 - f2, more = f1 + f2;
  pair.squared_sine = product(less, less) / 2 * (product(more, more) / 2);
  if (!(std::abs(pair.squared_sine) > kParallel)) {
    throw Error(Errc::irregular_surface,
                "a ball on two quadrics with parallel axes and equal slopes runs along them and "
                "closes no loop");
  }
  const PeVector between = spheres[0] - spheres[1];
  const double j1 = product(between, f1), j2 = product(between, f2);
  pair.nearest[0] = spheres[0] - (j1 - pair.cosine * j2) / pair.squared_sine * f1;
  pair.nearest[1] = spheres[1] + (j2 - pair.cosine * j1) / pair.squared_sine * f2;
  pair.apart = pair.nearest[0] - pair.nearest[1];
  pair.squared_distance = product(pair.apart, pair.apart);
  return pair;
}

std::size_t passed_through(const QuadricPair& pair) {
  const double size = std::abs(pair.nearest[0].r) + std::abs(pair.nearest[1].r);
  const double limit = 1e-3 * size;  // below it the loops have corners, or nearly
  if (!(pair.squared_sine > 0)) {
    throw Error(Errc::irregular_surface,
                "neither quadric passes through the other: their slopes are too large for the "
                "angle between the axes");
  }
  if (pair.squared_distance >= limit * limit) {
    throw Error(Errc::irregular_surface,
                "neither quadric passes through the other: each leaves it partly");
  }
  if (pair.squared_distance > -limit * limit) {
    throw Error(Errc::irregular_surface,
                "one quadric touches the other from inside, or nearly: their inscribed spheres "
                "differ by " +
                    decimal(std::abs(pair.apart.r), kMessageDigits) + " at a distance of " +
                    decimal(pair.apart.m.norm(), kMessageDigits) +
                    "; no rational fillet is regular there");
  }
  return pair.apart.r > 0 ? 0 : 1;
}

}  // namespace dupin::canal
