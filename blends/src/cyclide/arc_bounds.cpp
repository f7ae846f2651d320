#include "cyclide/arc_bounds.h"

#include <algorithm>
#include <cmath>

#include "dupin/kernel/error.h"

namespace dupin::cyclide {
namespace {

constexpr double kOne = 1, kTwo = 2;

numbers::IntervalVec difference(const Vec3& a, const Vec3& b) {
  return numbers::interval_vec(a) - numbers::interval_vec(b);
}

// The polar form of the quadratic with these Bernstein coefficients: its value for a = b, the
// middle coefficient on [a, b] otherwise.
numbers::Interval polar(const std::array<numbers::Interval, 3>& c, const numbers::Interval& a,
                        const numbers::Interval& b) {
  return (kOne - a) * (kOne - b) * c[0] + (a * (kOne - b) + b * (kOne - a)) * c[1] + a * b * c[2];
}

}  // namespace

// With d = end - start and e = <d, T0>: L^2 = <d, d>, w = e / L, K0 = (2 / L^2) (d - e T0), hence
// |A x k| = (2 / L^2) |A0 x d_m|; the tangent's Bezier points are T0, d / L, T2 = (2 w / L) d - T0.
ArcConstants::ArcConstants(const PeArc& arc) {
  const PeVector &b0 = arc.start(), &t0 = arc.start_tangent(), &b2 = arc.end();
  const numbers::IntervalVec dm = difference(b2.m, b0.m), a0 = numbers::interval_vec(t0.m);
  const numbers::Interval dr = numbers::Interval(b2.r) - b0.r, tau0 = t0.r;
  const numbers::Interval squared = numbers::dot(dm, dm) - square(dr),
                          e = numbers::dot(dm, a0) - dr * tau0;
  chord = numbers::sqrt(squared);
  if (!(chord.lower > 0)) {
    throw Error(Errc::irregular_surface, "a cyclide piece is too short for its coordinates");
  }
  w = e / chord;
  curvature_squared = numbers::Interval(4) * (kOne - w) * (kOne + w) / squared;
  turning = kTwo * numbers::norm(numbers::cross(a0, dm)) / squared;
  start_radius = b0.r;
  start_kappa = kTwo * (dr - e * tau0) / squared;
  radius = {b0.r, w * b0.r + chord * tau0 / kTwo, b2.r};
  tau = {tau0, dr / chord, kTwo * w * dr / chord - tau0};
}

// A rational quadratic lies between its coefficients on a stretch where the weights are positive.
ArcStretch stretch(const ArcConstants& arc, double from, double to) {
  const std::array<numbers::Interval, 3> weights{kOne, arc.w, kOne};
  const auto range = [&](const std::array<numbers::Interval, 3>& c) {
    numbers::Interval result;
    bool is_first = true;
    for (const auto& [a, b] : {std::pair(from, from), std::pair(from, to), std::pair(to, to)}) {
      const numbers::Interval weight = polar(weights, a, b);
      if (!(weight.lower > 0)) {
        throw Error(Errc::irregular_surface, "a cyclide piece passes too close to infinity");
      }
      const numbers::Interval value = polar(c, a, b) / weight;
      result = is_first ? value : numbers::hull(result, value);
      is_first = false;
    }
    return result;
  };
  const numbers::Interval radius = range(arc.radius);
  return {radius, range(arc.tau),
          arc.start_kappa - arc.curvature_squared * (radius - arc.start_radius)};
}

// A conic arc of half angle h has t / (1 - t) = sin(h s) / sin(h (1 - s)), hyperbolic for w > 1.
double parameter_at(const PeArc& arc, double fraction) {
  const double w = arc.w();
  if (fraction == 0 || fraction == 1 || w == 1) {
    return fraction;
  }
  const double half =
      w < 1 ? 2 * std::asin(std::sqrt((1 - w) / 2)) : 2 * std::asinh(std::sqrt((w - 1) / 2));
  const auto part = [&](double s) { return w < 1 ? std::sin(half * s) : std::sinh(half * s); };
  const double passed = part(fraction), left = part(1 - fraction);
  return passed / (passed + left);
}

// Circles of radius rho = r / s, s^2 = 1 + tau^2, about the unit normal n = A / s; e = cos u e1 +
// sin u e2 with the symmetry plane's normal e2 and e1 = e2 x n, n' = omega e1, omega = |A x k| /
// s^2. Then x' = D (n + tau e) + p sin u e_u with
//   D = g - rho omega cos u, g = (1 - r kappa / s^2) / s, p = tau rho omega,
// and, as tau' = kappa, kappa' = -kk tau, r' = tau, rho' = tau g, omega' = -2 omega tau kappa /
// s^2:
//   x'' = [D' - D tau omega cos u + p omega sin^2 u] n + [tau D' + D (omega cos u + kappa)] e
//         + [p' - D omega] sin u e_u,    x'_u = rho omega sin u n + tau g e_u,    x_uu = -rho e,
//   D' = g' - (tau g omega + rho omega') cos u, g' = tau (r kk - 2 kappa + 3 r kappa^2 / s^2) /
//   s^3, p' = kappa rho omega + tau^2 g omega + tau rho omega'.
ringed::BandBounds band_bounds(const PeArc& arc, const ArcConstants& constants, double from,
                               double to) {
  const auto [r, tau, kappa] = stretch(constants, parameter_at(arc, from), parameter_at(arc, to));
  const numbers::Interval s2 = kOne + square(tau), s = numbers::sqrt(s2), cosine(-1, 1),
                          sine(-1, 1);
  const numbers::Interval rho = r / s, omega = constants.turning / s2;
  const numbers::Interval g = (kOne - r * kappa / s2) / s;
  const numbers::Interval g1 = tau *
                               (r * constants.curvature_squared - kTwo * kappa +
                                numbers::Interval(3) * r * square(kappa) / s2) /
                               (s2 * s);
  const numbers::Interval omega1 = numbers::Interval(-2) * omega * tau * kappa / s2;
  const numbers::Interval d = g - rho * omega * cosine;
  const numbers::Interval d1 = g1 - (tau * g * omega + rho * omega1) * cosine;
  const numbers::Interval p = tau * rho * omega;
  const numbers::Interval p1 = kappa * rho * omega + square(tau) * g * omega + tau * rho * omega1;
  const numbers::Interval along_n = d1 - d * tau * omega * cosine + p * omega * square(sine);
  const numbers::Interval along_e = tau * d1 + d * (omega * cosine + kappa);
  const numbers::Interval along_u = (p1 - d * omega) * sine;
  // The tangential length is right to a few units in the last place; a part in 2^40 covers that.
  const numbers::Interval length = pe_length(arc) * (1 + std::ldexp(1.0, -40));
  const numbers::Interval second =
      numbers::sqrt(square(along_n) + square(along_e) + square(along_u));
  const numbers::Interval mixed = numbers::sqrt(square(rho * omega) + square(tau * g));
  return {{(second * square(length)).upper, (mixed * length).upper, rho.upper},
          (omega * length).upper};
}

}  // namespace dupin::cyclide
