#include "verification/elliptic_motion.h"

#include <algorithm>

#include "numbers/mpfi_interval.h"

namespace dupin::verification {
namespace {

IntervalVec rotated(const IntervalVec& v, const IntervalVec& from, const IntervalVec& to) {
  const IntervalVec axis = numbers::cross(from, to), turned = numbers::cross(axis, v);
  const Interval share = Interval(1) / (Interval(1) + numbers::dot(from, to));
  return v + turned + share * numbers::cross(axis, turned);
}

// An upper bound of the angle between the lines of the end's axis and of the start's as it arrives,
// turned by `turn`. It is carried in rotations from tangent to tangent: the least ones miss the
// frame that does not spin by less than 0.27 of the tangent's way, squared.
std::optional<Interval> arrival_error(const EllipticTube& tube, const Motion& moving) {
  constexpr int kRotations = 16;
  IntervalVec axis = numbers::interval_vec(tube.start.ellipse->axis), tangent;
  Interval missed = 0;
  for (int i = 0; i <= kRotations; ++i) {
    const double t = double(i) / kRotations, before = double(std::max(i - 1, 0)) / kRotations;
    const auto here = moving(t, t), way = moving(before, t);
    if (!here || !way) {
      return std::nullopt;
    }
    const IntervalVec normal = part(here->normal, 0);
    axis = i == 0 ? axis : rotated(axis, tangent, normal);
    tangent = normal;
    const Interval length = (Interval(t) - before) * numbers::norm(part(way->normal, 1));
    missed = missed + Interval(0.27) * square(length);
  }
  const Mpfi turn = tube.turn;
  const IntervalVec arrived =
      narrowed(cosine(turn)) * axis + narrowed(sine(turn)) * numbers::cross(tangent, axis);
  const IntervalVec wanted = numbers::interval_vec(tube.end.ellipse->axis);
  // Of directions but for rounding; two lines are at most a right angle apart.
  const Interval sine = numbers::norm(numbers::cross(arrived, wanted)) /
                        (numbers::norm(arrived) * numbers::norm(wanted));
  return narrowed(Mpfi::pi()) / 2 * sine + missed;
}

// The derivatives of the eased turn, in magnitude.
std::array<Interval, 2> turning(Continuity continuity, const Interval& turn, const Interval& t) {
  const Interval rise = t * (Interval(1) - t), bend = Interval(1) - Interval(2) * t;
  return continuity == Continuity::g1
             ? std::array{Interval((Interval(6) * rise * turn).magnitude()),
                          Interval((Interval(6) * bend * turn).magnitude())}
             : std::array{Interval((Interval(30) * square(rise) * turn).magnitude()),
                          Interval((Interval(60) * rise * bend * turn).magnitude())};
}

Interval about_zero(const Interval& bound) { return {-bound.upper, bound.upper}; }

// A point is z = (a cos u + i b sin u) e^(i phi) there, phi the turn: with w' for the derivative of
// the factor, |w'| <= max(|a'|, |b'|),
//   z' = (w' + i phi' w) e^(i phi),
//   z'' = (w'' + 2 i phi' w' + i phi'' w - phi'^2 w) e^(i phi).
Jet<3> bounds(const Jet<3>& a, const Jet<3>& b, const std::array<Interval, 2>& turning) {
  std::array<Interval, 3> most;
  for (std::size_t k = 0; k < 3; ++k) {
    most.at(k) = std::max(a[k].magnitude(), b[k].magnitude());
  }
  const auto& [size, slope, bend] = most;
  const auto& [rate, change] = turning;
  return {{about_zero(size), about_zero(slope + rate * size),
           about_zero(bend + Interval(2) * rate * slope + (change + square(rate)) * size)}};
}

}  // namespace

Motion elliptic_motion(const EllipticTube& tube, const std::array<Tube, 2>& axes) {
  const Motion first = motion(axes[0]), second = motion(axes[1]);
  Interval turn = Interval(tube.turn).magnitude();
  if (tube.start.ellipse && tube.end.ellipse) {
    const auto missed = arrival_error(tube, first);
    if (!missed) {
      return {};
    }
    turn = turn + *missed;
  }
  return [=, continuity = tube.continuity](double from, double to) -> std::optional<MovingDisc> {
    auto disc = first(from, to);
    const auto other = second(from, to);
    if (!disc || !other) {
      return std::nullopt;
    }
    disc->radius = bounds(disc->radius, other->radius, turning(continuity, turn, {from, to}));
    return disc;
  };
}

}  // namespace dupin::verification
