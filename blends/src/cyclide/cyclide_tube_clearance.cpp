#include <algorithm>
#include <cmath>
#include <limits>

#include "cyclide/exact_pe.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// <gamma - P, gamma - P> W with P = (x; -R) is a quadratic with the Bernstein coefficients
//   c0 = <b0 - P, b0 - P>,  c1 = w c0 + L <T0, b0 - P>,  c2 = <b2 - P, b2 - P>,
// positive on [0, 1] if and only if c0, c2 > 0 and c1 > -sqrt(c0 c2). With w = e / L, e = <d, T0>,
// the last condition times L is free of roots: e c0 + L^2 <T0, b0 - P> > -sqrt(L^2 c0 c2).
enum class Sign { positive, zero, negative };

Sign least_sign(const PeArc& arc, const Vec3& center, const mpq_class& radius) {
  const auto b0 = cyclide::exact(arc.start()), b2 = cyclide::exact(arc.end());
  const auto t0 = cyclide::exact(arc.start_tangent());
  cyclide::ExactPeVector p = cyclide::exact({center, 0});
  p.r = -radius;
  const auto to0 = b0 - p, to2 = b2 - p, d = b2 - b0;
  const mpq_class c0 = cyclide::product(to0, to0), c2 = cyclide::product(to2, to2);
  if (c0 < 0 || c2 < 0) {
    return Sign::negative;
  }
  const mpq_class squared = cyclide::product(d, d);
  const mpq_class c1 = cyclide::product(d, t0) * c0 + squared * cyclide::product(t0, to0);
  const mpq_class root = squared * c0 * c2;
  if (c0 > 0 && c2 > 0 && cyclide::exceeds_negative_root(c1, root)) {
    return Sign::positive;
  }
  return c1 >= 0 || c1 * c1 <= root ? Sign::zero : Sign::negative;
}

}  // namespace

bool keeps_distance(const PeArc& arc, const Sphere& ball, double distance) {
  if (!(distance >= 0) || !(ball.radius >= 0) || !std::isfinite(distance + ball.radius) ||
      !ball.center.allFinite()) {
    throw Error(Errc::invalid_argument,
                "a clearance needs a finite ball and a distance that is not negative");
  }
  return least_sign(arc, ball.center, mpq_class(ball.radius) + distance) == Sign::positive;
}

bool contains(const PeArc& arc, const Vec3& point) {
  if (!point.allFinite()) {
    throw Error(Errc::invalid_argument, "a point needs finite coordinates");
  }
  return least_sign(arc, point, 0) == Sign::negative;
}

double clearance(const PeArc& arc, const Sphere& ball) {
  return signed_distance(arc, ball.center) - ball.radius;
}

double clearance(const CyclideChain& chain, const Sphere& ball) {
  double least = std::numeric_limits<double>::infinity();
  for (const PeArc& arc : chain.pieces) {
    least = std::min(least, clearance(arc, ball));
  }
  return least;
}

}  // namespace dupin
