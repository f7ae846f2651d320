#include "ringed/second_derivatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <type_traits>
#include <vector>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/bezier.h"
#include "numbers/quaternion.h"

namespace dupin {
namespace ringed {
namespace {

// No constant: it might be needed before it is made, where a program's static objects use us.
numbers::Interval pi() { return {std::numbers::pi, std::nextafter(std::numbers::pi, 4.0)}; }

SpineBounds bounds(const LineSpine& line, const numbers::Interval&) {
  return {numbers::norm(numbers::interval_vec(line.to) - numbers::interval_vec(line.from)), 0, 0,
          0};
}

// T turns at the constant rate `angle`, so T'' = -angle^2 T has no part across T.
SpineBounds bounds(const ArcSpine& arc, const numbers::Interval&) {
  const numbers::Interval radius =
      numbers::norm(numbers::interval_vec(arc.start) - numbers::interval_vec(arc.center));
  return {radius * arc.angle, 0, arc.angle, 0};
}

// T' being y' x y'' / v^2 turned by a right angle, |T'| = |y' x y''| / v^2 and
// |T''_across| = |(y'''/v - 2 (v'/v^2) y'') x y'| / v. `bend` is y' x y'', `third_across` y''' x
// y'.
SpineBounds assembled(const numbers::IntervalVec& first, const numbers::IntervalVec& second,
                      const numbers::IntervalVec& bend, const numbers::IntervalVec& third_across,
                      const numbers::Interval& t) {
  const numbers::Interval speed = numbers::norm(first);
  if (!(speed.lower > 0)) {
    throw Error(Errc::irregular_surface,
                "the spine stops, or nearly so, between t = " + decimal(t.lower, kMessageDigits) +
                    " and " + decimal(t.upper, kMessageDigits));
  }
  const numbers::Interval acceleration = numbers::dot(first, second) / speed;
  const numbers::IntervalVec change = numbers::Interval(1) / speed * third_across +
                                      numbers::Interval(2) * (acceleration / square(speed)) * bend;
  return {speed, acceleration.magnitude(), (numbers::norm(bend) / square(speed)).upper,
          (numbers::norm(change) / speed).upper};
}

// y' = A + B t + D t^2. The cross products are expanded, so that nothing cancels between wide
// intervals:
//   y' x y''  = A x B + 2 t (A x D) + t^2 (B x D)
//   y''' x y' = 2 (D x A) + 2 t (D x B)
struct HermiteTerms {
  explicit HermiteTerms(const HermiteSpine& spine)
      : delta(numbers::interval_vec(spine.to) - numbers::interval_vec(spine.from)),
        a(numbers::interval_vec(spine.start_velocity)),
        e(numbers::interval_vec(spine.end_velocity)),
        b(numbers::Interval(6) * delta - numbers::Interval(4) * a - numbers::Interval(2) * e),
        d(numbers::Interval(3) * (a + e) - numbers::Interval(6) * delta),
        ab(numbers::cross(a, b)),
        twice_ad(numbers::Interval(2) * numbers::cross(a, d)),
        bd(numbers::cross(b, d)),
        da(numbers::cross(d, a)),
        db(numbers::cross(d, b)) {}

  numbers::IntervalVec delta, a, e, b, d, ab, twice_ad, bd, da, db;
};

SpineBounds bounds(const HermiteTerms& y, const numbers::Interval& t) {
  return assembled(y.a + t * (y.b + t * y.d), y.b + numbers::Interval(2) * (t * y.d),
                   y.ab + t * (y.twice_ad + t * y.bd), numbers::Interval(2) * (y.da + t * y.db), t);
}

SpineBounds bounds(const BezierSpine& spine, const numbers::Interval& t) {
  // About its first point, for less cancellation between the terms of a rational curve.
  std::vector<numbers::IntervalVec> points;
  for (std::size_t i = 0; i < spine.points.size(); ++i) {
    const numbers::Interval weight = spine.weights.empty() ? 1 : spine.weights[i];
    points.push_back(
        weight * (numbers::interval_vec(spine.points[i]) - numbers::interval_vec(spine.points[0])));
  }
  auto [y, y1, y2, y3] = numbers::bezier_jet(points, t);
  if (!spine.weights.empty()) {
    const auto [w, w1, w2, w3] = numbers::bezier_jet(
        std::vector<numbers::Interval>(spine.weights.begin(), spine.weights.end()), t);
    const numbers::Interval over_w = numbers::Interval(1) / w, two = 2, three = 3;
    y = over_w * y;
    y1 = over_w * (y1 - w1 * y);
    y2 = over_w * (y2 - two * w1 * y1 - w2 * y);
    y3 = over_w * (y3 - three * w1 * y2 - three * w2 * y1 - w3 * y);
  }
  return assembled(y1, y2, numbers::cross(y1, y2), numbers::cross(y3, y1), t);
}

RadiusBounds bounds(const ConstantRadius& law, const numbers::Interval&) {
  return {law.radius, 0, 0};
}

RadiusBounds bounds(const LinearRadius& law, const numbers::Interval& t) {
  const numbers::Interval change = numbers::Interval(law.end) - law.start;
  return {(law.start + change * t).upper, change.magnitude(), 0};
}

RadiusBounds bounds(const CubicRadius& law, const numbers::Interval& t) {
  const numbers::Interval change = numbers::Interval(law.end) - law.start;
  const auto eased = [](const numbers::Interval& at) {
    return square(at) * (numbers::Interval(3) - numbers::Interval(2) * at);
  };
  return {(law.start + change * numbers::hull(eased(t.lower), eased(t.upper))).upper,  // monotone
          (numbers::Interval(6) * change * (t * (numbers::Interval(1) - t))).magnitude(),
          (numbers::Interval(6) * change * (numbers::Interval(1) - numbers::Interval(2) * t))
              .magnitude()};
}

RadiusBounds bounds(const BezierRadius& law, const numbers::Interval& t) {
  const auto jet = numbers::bezier_jet(
      std::vector<numbers::Interval>(law.coefficients.begin(), law.coefficients.end()), t);
  return {jet[0].upper, jet[1].magnitude(), jet[2].magnitude()};
}

// cos or sin of pi t for a double t in [0, 1]. The double nearest to pi is off by less than 2^-52,
// the product rounds by at most 2^-52, and the C library's functions are off by less than 2^-53.
numbers::Interval widened(double value) {
  const double slack = std::ldexp(1.0, -50);
  return {std::max(value - slack, -1.0), std::min(value + slack, 1.0)};
}

numbers::Interval cosine_of_pi(const numbers::Interval& t) {  // falls on [0, 1]
  return numbers::hull(widened(std::cos(std::numbers::pi * t.upper)),
                       widened(std::cos(std::numbers::pi * t.lower)));
}

numbers::Interval sine_of_pi(const numbers::Interval& t) {  // concave on [0, 1], largest at 1/2
  const numbers::Interval ends = numbers::hull(widened(std::sin(std::numbers::pi * t.lower)),
                                               widened(std::sin(std::numbers::pi * t.upper)));
  return t.lower <= 0.5 && 0.5 <= t.upper ? numbers::Interval(ends.lower, 1) : ends;
}

RadiusBounds bounds(const CyclideRadius& law, const numbers::Interval& t) {
  const numbers::Interval change = numbers::Interval(law.end) - law.start;
  const numbers::Interval product = numbers::Interval(law.start) * law.end;
  const auto radius = [&](double at) {
    const numbers::Interval c = change * cosine_of_pi(at);
    const numbers::Interval w = numbers::sqrt(square(c) + numbers::Interval(4) * product);
    return c.upper <= 0 ? (w - c) / 2 : numbers::Interval(2) * product / (w + c);
  };
  const numbers::Interval value = numbers::hull(radius(t.lower), radius(t.upper));  // monotone
  const numbers::Interval c = change * cosine_of_pi(t), s = change * sine_of_pi(t);
  const numbers::Interval w = numbers::sqrt(square(c) + numbers::Interval(4) * product);
  const numbers::Interval first = pi() * s * value / w;
  const numbers::Interval second = pi() * (pi() * c * value / w + s * first / w +
                                           pi() * c * square(s) * value / (w * square(w)));
  return {value.upper, first.magnitude(), second.magnitude()};
}

// Bounds of the angle's first and second derivative.
struct TurnBounds {
  numbers::Interval rate, change;
};

TurnBounds turn_bounds(const EllipticTube& tube, const numbers::Interval& t) {
  const numbers::Interval rise = t * (numbers::Interval(1) - t), turn = tube.turn;
  const numbers::Interval bend = numbers::Interval(1) - numbers::Interval(2) * t;
  const numbers::Interval rate = tube.continuity == Continuity::g1
                                     ? numbers::Interval(6) * rise * turn
                                     : numbers::Interval(30) * square(rise) * turn;
  const numbers::Interval change = tube.continuity == Continuity::g1
                                       ? numbers::Interval(6) * bend * turn
                                       : numbers::Interval(60) * rise * bend * turn;
  return {rate.magnitude(), change.magnitude()};
}

// A quaternion polynomial and its derivatives.
using QuaternionRange = numbers::Quaternion<numbers::Interval>;

std::array<QuaternionRange, 3> rotation_range(const RationalRingedSurface& surface,
                                              const numbers::Interval& t) {
  std::array<QuaternionRange, 3> result;
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<numbers::Interval> points;
    for (const auto& q : surface.rotation) {
      points.emplace_back(q[part]);
    }
    const auto jet = numbers::bezier_jet(points, t);
    for (std::size_t order = 0; order < 3; ++order) {
      result[order][part] = jet[order];
    }
  }
  return result;
}

numbers::IntervalVec vector_part(const QuaternionRange& q) { return {q[1], q[2], q[3]}; }

struct Spin {
  double rate = 0, change = 0;  // bounds of |omega|, |omega'|
};

// The frame A (i, j, k) A* / |A|^2 turns with omega = 2 vec(A' A*) / |A|^2. As A' A'* is real,
//   omega' = 2 vec(A'' A*) / |A|^2 - omega (|A|^2)' / |A|^2.
Spin spin_bounds(const RationalRingedSurface& surface, const numbers::Interval& t) {
  const auto [a, a1, a2] = rotation_range(surface, t);
  const QuaternionRange back = numbers::conjugate(a);
  const numbers::Interval size = square(a[0]) + square(a[1]) + square(a[2]) + square(a[3]);
  const numbers::Interval growth =
      numbers::Interval(2) * (a[0] * a1[0] + a[1] * a1[1] + a[2] * a1[2] + a[3] * a1[3]);
  const numbers::IntervalVec omega =
      numbers::Interval(2) / size * vector_part(numbers::product(a1, back));
  const numbers::IntervalVec change =
      numbers::Interval(2) / size * vector_part(numbers::product(a2, back)) - growth / size * omega;
  return {numbers::norm(omega).upper, numbers::norm(change).upper};
}

// Bounds on one interval after the other, of what is worked out once.
std::function<SpineBounds(const numbers::Interval&)> spine_terms(const Spine& spine) {
  return std::visit(
      []<class S>(const S& s) -> std::function<SpineBounds(const numbers::Interval&)> {
        if constexpr (std::is_same_v<S, HermiteSpine>) {
          return [terms = HermiteTerms(s)](const numbers::Interval& t) { return bounds(terms, t); };
        } else {
          return [&s](const numbers::Interval& t) { return bounds(s, t); };
        }
      },
      spine);
}

// In a rotation-minimising frame e' = -(e.T') T, hence (mathematics of [MS06] surfaces)
//   x_tt = (v' - 2 R' e.T' - R e.T'') T + (v - R e.T') T' + R'' e,
//   x_tu = -R (e_u.T') T + R' e_u,   x_uu = -R e.
BandBounds band_bounds(const SpineBounds& y, const RadiusBounds& r) {
  const numbers::Interval radius = r.value, slope = r.first, turning = y.turning;
  const numbers::Interval along_axis = numbers::Interval(y.acceleration) +
                                       numbers::Interval(2) * slope * turning +
                                       radius * numbers::Interval(y.turning_change);
  const numbers::Interval across =
      (y.speed + radius * turning) * turning + numbers::Interval(r.second);
  return {{numbers::sqrt(square(along_axis) + square(across)).upper,
           numbers::sqrt(square(slope) + square(radius * turning)).upper, r.value},
          y.turning};
}

}  // namespace

SpineBounds spine_bounds(const Spine& spine, const numbers::Interval& t) {
  return spine_terms(spine)(t);
}

RadiusBounds radius_bounds(const RadiusLaw& law, const numbers::Interval& t) {
  return std::visit([&](const auto& l) { return bounds(l, t); }, law);
}

BandBounds band_bounds(const RingedSurface& surface, double from, double to) {
  const numbers::Interval t(from, to);
  return band_bounds(spine_bounds(surface.spine, t), radius_bounds(surface.radius, t));
}

std::vector<BandBounds> band_bounds_of_cells(const RingedSurface& surface, std::uint32_t cells) {
  const auto spine = spine_terms(surface.spine);
  std::vector<BandBounds> result;
  result.reserve(cells);
  for (std::uint32_t i = 0; i < cells; ++i) {
    const numbers::Interval t(double(i) / cells, double(i + 1) / cells);
    result.push_back(band_bounds(spine(t), radius_bounds(surface.radius, t)));
  }
  return result;
}

// With p = a cos u c1 + b sin u c2 and its change w in the turning frame, |w| <= |a'|, |b'| and
// turn' times the radius together:
//   x_tt = (v' - 2 w.T' - p.T'') T + (v - p.T') T' + w',
//   w' = a'' cos u c1 + b'' sin u c2 + 2 turn' (a' cos u c2 - b' sin u c1)
//        + turn'' (a cos u c2 - b sin u c1) - turn'^2 p,
//   x_tu = q' with q = b cos u c2 - a sin u c1, x_uu = -p.
BandBounds band_bounds(const EllipticTube& tube, double from, double to) {
  const numbers::Interval t(from, to);
  const SpineBounds y = spine_bounds(tube.spine, t);
  const RadiusBounds a = radius_bounds(tube.first, t), b = radius_bounds(tube.second, t);
  const auto [rate, change] = turn_bounds(tube, t);
  const numbers::Interval radius = std::max(a.value, b.value), slope = std::max(a.first, b.first);
  const numbers::Interval bend = std::max(a.second, b.second), turning = y.turning;
  const numbers::Interval drift = slope + rate * radius;
  const numbers::Interval along_axis = numbers::Interval(y.acceleration) +
                                       numbers::Interval(2) * drift * turning +
                                       radius * numbers::Interval(y.turning_change);
  const numbers::Interval across = (y.speed + radius * turning) * turning + bend +
                                   numbers::Interval(2) * rate * slope +
                                   (change + square(rate)) * radius;
  return {{numbers::sqrt(square(along_axis) + square(across)).upper,
           numbers::sqrt(square(drift) + square(radius * turning)).upper, radius.upper},
          y.turning};
}

// With the frame's rotation omega, e' = omega x e:
//   x_tt = d'' + r'' e + 2 r' omega x e + r (omega' x e + omega x (omega x e)),
//   x_tv = r' e_v + r omega x e_v, x_vv = -r e.
BandBounds band_bounds(const RationalRingedSurface& surface, double from, double to) {
  const numbers::Interval t(from, to);
  std::vector<numbers::IntervalVec> points;
  for (const Vec3& point : surface.center) {
    points.push_back(numbers::interval_vec(point));
  }
  const auto d = numbers::bezier_jet(points, t);
  const auto r = numbers::bezier_jet(
      std::vector<numbers::Interval>(surface.radius.begin(), surface.radius.end()), t);
  const Spin spin = spin_bounds(surface, t);
  const numbers::Interval rate = spin.rate, radius = r[0].magnitude(), slope = r[1].magnitude();
  const numbers::Interval along = numbers::norm(d[2]) + numbers::Interval(r[2].magnitude()) +
                                  numbers::Interval(2) * slope * rate +
                                  radius * (numbers::Interval(spin.change) + square(rate));
  return {{along.upper, (slope + radius * rate).upper, radius.upper}, 0};
}

}  // namespace ringed

SecondDerivativeBounds second_derivative_bounds(const RingedSurface& surface, double from,
                                                double to) {
  if (!(0 <= from && from <= to && to <= 1)) {
    throw Error(Errc::invalid_argument, "a range of spine parameters must lie in [0, 1]");
  }
  return ringed::band_bounds(surface, from, to).second;
}

}  // namespace dupin
