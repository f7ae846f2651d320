#include "verification/motions/motion.h"

#include <algorithm>

#include "verification/motions/bernstein.h"

namespace dupin::verification {
namespace {

Jet<3> one() { return {{1, 0, 0}}; }

std::optional<MovingDisc> across(const JetVec<4>& spine, const IntervalVec& base,
                                 const Jet<3>& radius) {
  spend(kDiscWork);
  const JetVec<3> velocity = derivative(spine);
  const Jet<3> squared = squared_norm(velocity);
  if (!(squared[0].lower > 0)) {
    return std::nullopt;
  }
  const JetVec<3> center = shortened<3>(spine);
  return MovingDisc{moved(center, base), velocity / sqrt(squared), radius, one()};
}

// R^2 + c R = r0 r1 with c = (r1 - r0) cos(pi t).
Jet<3> cyclide_radius(const Tube& tube, double from, double to) {
  const auto& law = std::get<CyclideRadius>(tube.surface().radius);
  const Interval rise = Interval(law.end) - law.start, half = 0.5;
  const Mpfi turned = Mpfi::pi() * Mpfi::between(from, to);
  const Interval pi = narrowed(Mpfi::pi()), cos = narrowed(cosine(turned));
  const Jet<3> c{{rise * cos, -pi * rise * narrowed(sine(turned)), -square(pi) * rise * cos}};
  Jet<3> squared = c * c;
  squared[0] = square(c[0]) + Interval(4) * law.start * law.end;
  Jet<3> result = sqrt(squared) - c;
  for (Interval& x : result.d) {
    x = half * x;
  }
  result[0] = tube.radius_range(from, to);
  return result;
}

std::function<Jet<3>(double, double)> radius_of(const Tube& tube) {
  const Polynomial radius = tube.radius(0, 1);
  if (radius.empty()) {
    return [tube](double from, double to) { return cyclide_radius(tube, from, to); };
  }
  return [r = Enclosed<3>(radius)](double from, double to) { return r.over(from, to); };
}

Motion arc_motion(const Tube& tube) {
  const ArcSpine arc = *tube.arc();
  const IntervalVec base = numbers::interval_vec(arc.center);
  const IntervalVec u = numbers::interval_vec(arc.start) - base;
  const IntervalVec v = numbers::cross(numbers::interval_vec(arc.axis), u);
  // The disc in the middle, turned about the axis, is any other: but for the radius, nothing that
  // is asked of the motion of a circular arc changes along it.
  return [=, radius = radius_of(tube)](double from, double to) {
    const Interval rate = arc.angle;
    const Mpfi turned = Mpfi(arc.angle) * (Mpfi(from) + to) / 2;
    const Interval c = narrowed(cosine(turned)), s = narrowed(sine(turned));
    const Jet<4> cos{{c, -rate * s, -square(rate) * c, square(rate) * rate * s}};
    const Jet<4> sin{{s, rate * c, -square(rate) * s, -square(rate) * rate * c}};
    JetVec<4> y;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t order = 0; order < 4; ++order) {
        y[k][order] = cos[order] * u[k] + sin[order] * v[k];
      }
    }
    return across(y, base, radius(from, to));
  };
}

// How the direction of a curve q changes: with w = q x q', which is exactly 0 where the curve is
// straight, and nearly where it nearly is,
//   (q / |q|)' = w x q / |q|^3.
class Direction {
 public:
  explicit Direction(const Curve& q) {
    if (q[0].size() <= kMostCoefficients) {
      q_.emplace(q);
      turning_.emplace(cross(q, derivative(q)));
    }
  }

  // The derivatives of the unit vector along q.
  void sharpen(JetVec<3>& unit, double from, double to) const {
    if (!q_) {
      return;
    }
    const JetVec<2> q = q_->over(from, to), w = turning_->over(from, to);
    const Jet<2> squared = squared_norm(q);
    if (!(squared[0].lower > 0)) {
      return;
    }
    const Jet<2> cubed = squared * sqrt(squared);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const Jet<2> rate = (w[i] * q[j] - w[j] * q[i]) / cubed;
      unit[k][1] = rate[0];
      unit[k][2] = rate[1];
    }
  }

 private:
  static constexpr std::size_t kMostCoefficients = 16;  // the work grows with the cube
  std::optional<EnclosedCurve<2>> q_, turning_;
};

// The polynomial over t, which divides it, or over 1 - t.
Polynomial over_t(const Polynomial& p) {
  Polynomial q;
  const auto n = static_cast<unsigned long>(p.size() - 1);
  for (unsigned long i = 1; i <= n; ++i) {
    q.push_back(p[i] * mpq_class(n) / mpq_class(i));
  }
  return q;
}

Polynomial mirrored(Polynomial p) {
  std::reverse(p.begin(), p.end());
  return p;
}

std::array<Polynomial, 4> quaternion(const RationalRingedSurface& surface) {
  std::array<Polynomial, 4> q;
  for (std::size_t part = 0; part < 4; ++part) {
    for (const auto& control : surface.rotation) {
      q[part].emplace_back(control[part]);
    }
  }
  return q;
}

// A i A*, along the normals.
Curve rotated_axis(const std::array<Polynomial, 4>& q) {
  const auto twice = [](const Polynomial& p) { return product(p, {2}); };
  const auto minus = [](const Polynomial& p) { return product(p, {-1}); };
  const auto& [w, x, y, z] = q;
  return {difference(difference(product(w, w), minus(product(x, x))),
                     difference(product(y, y), minus(product(z, z)))),
          twice(difference(product(x, y), minus(product(w, z)))),
          twice(difference(product(x, z), product(w, y)))};
}

struct RingedCurves {
  Curve center, axis;
  Polynomial radius;
};

RingedCurves curves(const RationalRingedSurface& surface) {
  RingedCurves result;
  for (int k = 0; k < 3; ++k) {
    for (const Vec3& point : surface.center) {
      result.center[k].emplace_back(mpq_class(point[k]) - mpq_class(surface.center[0][k]));
    }
  }
  result.axis = rotated_axis(quaternion(surface));
  result.radius = {surface.radius.begin(), surface.radius.end()};
  return result;
}

// 2 vec(A' A*) / |A|^2 = 2 (w v' - w' v - v' x v) / |A|^2 with A = (w; v), and its derivative.
std::optional<std::array<IntervalVec, 2>> spin(const Jet<3>& scalar, const JetVec<3>& vector) {
  const auto first_two = [](const Jet<3>& a) { return Jet<2>{{a[0], a[1]}}; };
  const Jet<2> w = first_two(scalar), w1 = derivative(scalar);
  const JetVec<2> v{first_two(vector[0]), first_two(vector[1]), first_two(vector[2])};
  const JetVec<2> v1 = derivative(vector);
  Jet<2> squared = squared_norm(v) + w * w;
  squared[0] = squared_norm(v)[0] + square(w[0]);
  if (!(squared[0].lower > 0)) {
    return std::nullopt;
  }
  const Jet<2> two{{2, 0}};
  JetVec<2> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    result[k] = two * (w * v1[k] - w1 * v[k] - (v1[i] * v[j] - v1[j] * v[i])) / squared;
  }
  return std::array<IntervalVec, 2>{part(result, 0), part(result, 1)};
}

bool rests(const Curve& rate, End end) {
  return std::all_of(rate.begin(), rate.end(), [=](const Polynomial& p) {
    return (end == End::end ? p.back() : p.front()) == 0;
  });
}

EnclosedCurve<1> unrested(const Curve& rate, End end) {
  Curve result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = end == End::end ? mirrored(over_t(mirrored(rate[k]))) : over_t(rate[k]);
  }
  return EnclosedCurve<1>(result);
}

void replace(JetVec<3>& jets, const JetVec<1>& rates) {
  for (std::size_t k = 0; k < 3; ++k) {
    jets[k][1] = rates[k][0];
  }
}

}  // namespace

Motion motion(const Tube& tube) {
  if (tube.arc() != nullptr) {
    return arc_motion(tube);
  }
  Stretch s = tube.stretch(0, 1);
  IntervalVec base;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class first = s.points[k].front() / s.weight.front();
    s.points[k] = about(s.points[k], s.weight, first);
    base[k] = enclosed(first);
  }
  return [base, points = EnclosedCurve<4>(s.points), weight = Enclosed<4>(s.weight),
          direction = Direction(s.tangent), is_rational = s.weight.size() > 1,
          radius = radius_of(tube)](double from, double to) -> std::optional<MovingDisc> {
    const JetVec<4> p = points.over(from, to);
    const Jet<4> w = weight.over(from, to);
    if (!(w[0].lower > 0)) {
      return std::nullopt;
    }
    auto disc = across(is_rational ? p / w : p, base, radius(from, to));
    if (disc) {
      direction.sharpen(disc->normal, from, to);
    }
    return disc;
  };
}

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

Motion motion(const EllipticTube& tube, const Motion& first, const Tube& second) {
  Interval turn = Interval(tube.turn).magnitude();
  if (tube.start.ellipse && tube.end.ellipse) {
    const auto missed = arrival_error(tube, first);
    if (!missed) {
      return {};
    }
    turn = turn + *missed;
  }
  const auto other = radius_of(second);
  return [=, continuity = tube.continuity](double from, double to) -> std::optional<MovingDisc> {
    auto disc = first(from, to);
    if (disc) {
      disc->radius = bounds(disc->radius, other(from, to), turning(continuity, turn, {from, to}));
    }
    return disc;
  };
}

Motion motion(const RationalRingedSurface& surface) {
  const RingedCurves c = curves(surface);
  const auto q = quaternion(surface);
  return [base = numbers::interval_vec(surface.center[0]), center = EnclosedCurve<3>(c.center),
          axis = EnclosedCurve<3>(c.axis), radius = Enclosed<3>(c.radius),
          scalar = Enclosed<3>(q[0]), vector = EnclosedCurve<3>({q[1], q[2], q[3]})](
             double from, double to) -> std::optional<MovingDisc> {
    spend(kDiscWork);
    const JetVec<3> n = axis.over(from, to);
    const Jet<3> squared = squared_norm(n);
    if (!(squared[0].lower > 0)) {
      return std::nullopt;
    }
    return MovingDisc{moved(center.over(from, to), base), n / sqrt(squared), radius.over(from, to),
                      one(), spin(scalar.over(from, to), vector.over(from, to))};
  };
}

Motion steered_motion(const RationalRingedSurface& surface) {
  const RingedCurves c = curves(surface);
  const Curve velocity = derivative(c.center), turning = derivative(c.axis);
  const std::array<bool, 2> resting{rests(velocity, End::start) && rests(turning, End::start),
                                    rests(velocity, End::end) && rests(turning, End::end)};
  if (!resting[0] && !resting[1]) {
    return motion(surface);
  }
  return [=, center = EnclosedCurve<3>(c.center), axis = EnclosedCurve<3>(c.axis),
          radius = Enclosed<3>(c.radius)](double from, double to) -> std::optional<MovingDisc> {
    spend(kDiscWork);
    JetVec<3> d = center.over(from, to), n = axis.over(from, to);
    for (const End end : {End::start, End::end}) {
      if (resting.at(at(end)) && (end == End::end ? to == 1 : from == 0)) {
        replace(d, unrested(velocity, end).over(from, to));
        replace(n, unrested(turning, end).over(from, to));
      }
    }
    const Jet<3> squared = squared_norm(n);
    if (!(squared[0].lower > 0)) {
      return std::nullopt;
    }
    return MovingDisc{d, n / sqrt(squared), radius.over(from, to), one()};
  };
}

}  // namespace dupin::verification
