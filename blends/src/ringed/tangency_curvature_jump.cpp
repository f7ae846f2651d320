#include "dupin/blends/tangency.h"
#include "dupin/kernel/error.h"
#include "ringed/second_derivatives.h"

namespace dupin {

// With q = v - R e.T', x_t = q T + R' e, and the normal curvature along x_t is
//   (q (q e.T' + R'') - R' (v' - 2 R' e.T' - R e.T'')) / (q^2 + R'^2)^(3/2).
double curvature_jump_bound(const RingedSurface& surface, End end) {
  using numbers::Interval;
  const double t = end == End::start ? 0 : 1;
  const ringed::SpineBounds y = ringed::spine_bounds(surface.spine, t);
  const ringed::RadiusBounds r = ringed::radius_bounds(surface.radius, t);
  const Interval any_sign(-1, 1), radius = r.value, first = any_sign * r.first;
  const Interval bend = any_sign * y.turning;
  const Interval q = y.speed - radius * bend;
  if (!(q.lower > 0)) {
    throw Error(Errc::irregular_surface, "the surface folds at its end ring", {},
                end == End::start ? "t = 0" : "t = 1");
  }
  const Interval along =
      any_sign * y.acceleration - Interval(2) * first * bend - radius * any_sign * y.turning_change;
  const Interval numerator = q * (q * bend + any_sign * r.second) - first * along;
  const Interval squared = square(q) + square(first);
  return (numerator / (squared * numbers::sqrt(squared))).magnitude();
}

}  // namespace dupin
