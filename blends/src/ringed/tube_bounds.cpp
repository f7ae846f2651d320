#include <algorithm>
#include <vector>

#include "numbers/interval_bezier.h"
#include "numbers/quaternion.h"
#include "ringed/second_derivatives.h"

namespace dupin::ringed {
namespace {

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

}  // namespace

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

}  // namespace dupin::ringed
