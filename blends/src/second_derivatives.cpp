#include "second_derivatives.h"

#include <cmath>
#include <numbers>

#include "dupin/kernel/error.h"
#include "interval_bezier.h"

namespace dupin {
namespace detail {
namespace {

const Interval kPi(std::numbers::pi, std::nextafter(std::numbers::pi, 4.0));

SpineBounds bounds(const LineSpine& line, const Interval&) {
  return {norm(interval_vec(line.to) - interval_vec(line.from)), 0, 0, 0};
}

// T turns at the constant rate `angle`, so T'' = -angle^2 T has no part across T.
SpineBounds bounds(const ArcSpine& arc, const Interval&) {
  const Interval radius = norm(interval_vec(arc.start) - interval_vec(arc.center));
  return {radius * arc.angle, 0, arc.angle, 0};
}

// T' being y' x y'' / v^2 turned by a right angle, |T'| = |y' x y''| / v^2 and
// |T''_across| = |(y'''/v - 2 (v'/v^2) y'') x y'| / v. `bend` is y' x y'', `third_across` y''' x
// y'.
SpineBounds assembled(const IntervalVec& first, const IntervalVec& second, const IntervalVec& bend,
                      const IntervalVec& third_across, const Interval& t) {
  const Interval speed = norm(first);
  if (!(speed.lower > 0)) {
    throw Error(Errc::irregular_surface,
                "the spine stops, or nearly so, between t = " + std::to_string(t.lower) + " and " +
                    std::to_string(t.upper));
  }
  const Interval acceleration = dot(first, second) / speed;
  const IntervalVec change =
      Interval(1) / speed * third_across + Interval(2) * (acceleration / square(speed)) * bend;
  return {speed, acceleration.magnitude(), (norm(bend) / square(speed)).upper,
          (norm(change) / speed).upper};
}

// y' = A + B t + D t^2. The cross products are expanded, so that nothing cancels between wide
// intervals:
//   y' x y''  = A x B + 2 t (A x D) + t^2 (B x D)
//   y''' x y' = 2 (D x A) + 2 t (D x B)
SpineBounds bounds(const HermiteSpine& spine, const Interval& t) {
  const IntervalVec delta = interval_vec(spine.to) - interval_vec(spine.from);
  const IntervalVec a = interval_vec(spine.start_velocity), e = interval_vec(spine.end_velocity);
  const IntervalVec b = Interval(6) * delta - Interval(4) * a - Interval(2) * e;
  const IntervalVec d = Interval(3) * (a + e) - Interval(6) * delta;
  return assembled(a + t * (b + t * d), b + Interval(2) * (t * d),
                   cross(a, b) + t * (Interval(2) * cross(a, d) + t * cross(b, d)),
                   Interval(2) * (cross(d, a) + t * cross(d, b)), t);
}

SpineBounds bounds(const BezierSpine& spine, const Interval& t) {
  // About its first point, for less cancellation between the terms of a rational curve.
  std::vector<IntervalVec> points;
  for (std::size_t i = 0; i < spine.points.size(); ++i) {
    const Interval weight = spine.weights.empty() ? 1 : spine.weights[i];
    points.push_back(weight * (interval_vec(spine.points[i]) - interval_vec(spine.points[0])));
  }
  auto [y, y1, y2, y3] = bezier_jet(points, t);
  if (!spine.weights.empty()) {
    const auto [w, w1, w2, w3] =
        bezier_jet(std::vector<Interval>(spine.weights.begin(), spine.weights.end()), t);
    const Interval over_w = Interval(1) / w, two = 2, three = 3;
    y = over_w * y;
    y1 = over_w * (y1 - w1 * y);
    y2 = over_w * (y2 - two * w1 * y1 - w2 * y);
    y3 = over_w * (y3 - three * w1 * y2 - three * w2 * y1 - w3 * y);
  }
  return assembled(y1, y2, cross(y1, y2), cross(y3, y1), t);
}

RadiusBounds bounds(const ConstantRadius& law, const Interval&) { return {law.radius, 0, 0}; }

RadiusBounds bounds(const LinearRadius& law, const Interval& t) {
  const Interval change = Interval(law.end) - law.start;
  return {(law.start + change * t).upper, change.magnitude(), 0};
}

RadiusBounds bounds(const CubicRadius& law, const Interval& t) {
  const Interval change = Interval(law.end) - law.start;
  const auto eased = [](const Interval& at) {
    return square(at) * (Interval(3) - Interval(2) * at);
  };
  return {(law.start + change * hull(eased(t.lower), eased(t.upper))).upper,  // monotone
          (Interval(6) * change * (t * (Interval(1) - t))).magnitude(),
          (Interval(6) * change * (Interval(1) - Interval(2) * t)).magnitude()};
}

RadiusBounds bounds(const BezierRadius& law, const Interval& t) {
  const auto jet =
      bezier_jet(std::vector<Interval>(law.coefficients.begin(), law.coefficients.end()), t);
  return {jet[0].upper, jet[1].magnitude(), jet[2].magnitude()};
}

// cos or sin of pi t for a double t in [0, 1]. The double nearest to pi is off by less than 2^-52,
// the product rounds by at most 2^-52, and the C library's functions are off by less than 2^-53.
Interval widened(double value) {
  const double slack = std::ldexp(1.0, -50);
  return {std::max(value - slack, -1.0), std::min(value + slack, 1.0)};
}

Interval cosine_of_pi(const Interval& t) {  // falls on [0, 1]
  return hull(widened(std::cos(std::numbers::pi * t.upper)),
              widened(std::cos(std::numbers::pi * t.lower)));
}

Interval sine_of_pi(const Interval& t) {  // concave on [0, 1], largest at 1/2
  const Interval ends = hull(widened(std::sin(std::numbers::pi * t.lower)),
                             widened(std::sin(std::numbers::pi * t.upper)));
  return t.lower <= 0.5 && 0.5 <= t.upper ? Interval(ends.lower, 1) : ends;
}

RadiusBounds bounds(const CyclideRadius& law, const Interval& t) {
  const Interval change = Interval(law.end) - law.start;
  const Interval product = Interval(law.start) * law.end;
  const auto radius = [&](double at) {
    const Interval c = change * cosine_of_pi(at);
    const Interval w = sqrt(square(c) + Interval(4) * product);
    return c.upper <= 0 ? (w - c) / 2 : Interval(2) * product / (w + c);
  };
  const Interval value = hull(radius(t.lower), radius(t.upper));  // monotone
  const Interval c = change * cosine_of_pi(t), s = change * sine_of_pi(t);
  const Interval w = sqrt(square(c) + Interval(4) * product);
  const Interval first = kPi * s * value / w;
  const Interval second =
      kPi * (kPi * c * value / w + s * first / w + kPi * c * square(s) * value / (w * square(w)));
  return {value.upper, first.magnitude(), second.magnitude()};
}

}  // namespace

SpineBounds spine_bounds(const Spine& spine, const Interval& t) {
  return std::visit([&](const auto& s) { return bounds(s, t); }, spine);
}

RadiusBounds radius_bounds(const RadiusLaw& law, const Interval& t) {
  return std::visit([&](const auto& l) { return bounds(l, t); }, law);
}

// In a rotation-minimising frame e' = -(e.T') T, hence (mathematics of [MS06] surfaces)
//   x_tt = (v' - 2 R' e.T' - R e.T'') T + (v - R e.T') T' + R'' e,
//   x_tu = -R (e_u.T') T + R' e_u,   x_uu = -R e.
BandBounds band_bounds(const RingedSurface& surface, double from, double to) {
  const Interval t(from, to);
  const SpineBounds y = spine_bounds(surface.spine, t);
  const RadiusBounds r = radius_bounds(surface.radius, t);
  const Interval radius = r.value, slope = r.first, turning = y.turning;
  const Interval along_axis = Interval(y.acceleration) + Interval(2) * slope * turning +
                              radius * Interval(y.turning_change);
  const Interval across = (y.speed + radius * turning) * turning + Interval(r.second);
  return {{sqrt(square(along_axis) + square(across)).upper,
           sqrt(square(slope) + square(radius * turning)).upper, r.value},
          y.turning};
}

}  // namespace detail

SecondDerivativeBounds second_derivative_bounds(const RingedSurface& surface, double from,
                                                double to) {
  if (!(0 <= from && from <= to && to <= 1)) {
    throw Error(Errc::invalid_argument, "a range of spine parameters must lie in [0, 1]");
  }
  return detail::band_bounds(surface, from, to).second;
}

}  // namespace dupin
