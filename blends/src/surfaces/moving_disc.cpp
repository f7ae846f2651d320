#include "surfaces/moving_disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "numbers/bezier.h"
#include "numbers/quaternion.h"

namespace dupin::surfaces {
namespace {

// Bernstein coefficients of a polynomial that t divides, over t.
template <class T>
std::vector<T> over_t(const std::vector<T>& p) {
  std::vector<T> q;
  const auto degree = static_cast<double>(p.size() - 1);
  for (std::size_t i = 1; i < p.size(); ++i) {
    q.push_back(numbers::Interval(degree) / double(i) * p[i]);
  }
  return q;
}

// The derivative of a Bezier polynomial on t, over t or 1 - t if `start` or `end`, where it must
// vanish.
template <class T>
T rate(const std::vector<T>& points, const numbers::Interval& t, bool start, bool end) {
  std::vector<T> difference;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    difference.push_back(numbers::Interval(double(points.size() - 1)) *
                         (points[i + 1] - points[i]));
  }
  if (start) {
    difference = over_t(difference);
  } else if (end) {
    std::reverse(difference.begin(), difference.end());
    difference = over_t(difference);
    std::reverse(difference.begin(), difference.end());
  }
  return numbers::bezier_range(difference, t);
}

bool rests(const RationalRingedSurface& surface, End end) {
  const auto& [center, radius, rotation] = surface;
  return end == End::end
             ? center[3] == center[2] && rotation.back() == rotation[rotation.size() - 2]
             : center[0] == center[1] && rotation[0] == rotation[1];
}

numbers::IntervalVec axis_of(const numbers::Quaternion<numbers::Interval>& a,
                             const numbers::Quaternion<numbers::Interval>& b) {
  const numbers::Quaternion<numbers::Interval> unit{0, 1, 0, 0};
  const auto n = numbers::product(numbers::product(a, unit), numbers::conjugate(b));
  return {n[1], n[2], n[3]};
}

// The spheres (m; r) = p / w of an arc, less the first one, in Bernstein form; and w^2 (m'; r') is
// a (tangent) + b (last - first), where a and b are quadratic and a b' - a' b = k w.
struct ArcSpheres {
  explicit ArcSpheres(const CyclidePiece& piece)
      : tangent(numbers::interval_vec(piece.tangent.m)),
        d(numbers::interval_vec(piece.last.m) - numbers::interval_vec(piece.first.m)),
        dr(numbers::Interval(piece.last.r) - piece.first.r) {
    const numbers::Interval squared = numbers::dot(d, d) - square(dr), chord = piece.chord;
    const numbers::Interval along = numbers::dot(d, tangent) - dr * piece.tangent.r;
    const numbers::Interval last = squared / square(chord), half = squared / (2 * chord);
    weights = {1, along / chord, last};
    centers = {{}, half * tangent, last * d};
    radii = {0, half * piece.tangent.r, last * dr};
    k = numbers::Interval(4) * half * last;
  }

  numbers::IntervalVec tangent, d;
  numbers::Interval dr, k;
  std::vector<numbers::Interval> weights, radii;
  std::vector<numbers::IntervalVec> centers;
};

// The arc's own centre less its first sphere, about; none where it has none, or too far away.
std::optional<PeVector> center_of_arc(const CyclidePiece& piece) {
  const PeVector &t = piece.tangent, d{piece.last.m - piece.first.m, piece.last.r - piece.first.r};
  const auto product = [](const PeVector& a, const PeVector& b) {
    return a.m.dot(b.m) - a.r * b.r;
  };
  const double unit = product(t, t), along = product(t, d), squared = product(d, d);
  const double share = squared / (2 * (unit * squared - along * along));
  const PeVector center{share * (unit * d.m - along * t.m), share * (unit * d.r - along * t.r)};
  return center.m.allFinite() && std::isfinite(center.r) ? std::optional(center) : std::nullopt;
}

// The square of a quadratic polynomial.
std::vector<numbers::Interval> squared(const std::vector<numbers::Interval>& p) {
  return {square(p[0]), p[0] * p[1], (p[0] * p[2] + numbers::Interval(2) * square(p[1])) / 3,
          p[1] * p[2], square(p[2])};
}

// <w^2 x', w^2 x'> for x = p / w, where p w' - p' w is quadratic.
std::vector<numbers::Interval> squared_pace(const ArcSpheres& arc) {
  const auto rate = [&](const auto& p) {
    const auto& w = arc.weights;
    return std::vector<numbers::Interval>{2 * (w[0] * p(1) - w[1] * p(0)),
                                          w[0] * p(2) - w[2] * p(0),
                                          2 * (w[1] * p(2) - w[2] * p(1))};
  };
  std::vector<numbers::Interval> sum(5);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto term =
        squared(rate([&](std::size_t i) { return k < 3 ? arc.centers[i][k] : arc.radii[i]; }));
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = k < 3 ? sum[i] + term[i] : sum[i] - term[i];
    }
  }
  return sum;
}

// <y, y> - c w^2 for y = p - o w, with the c that makes it 0 at the start.
std::vector<numbers::Interval> off_sphere(const ArcSpheres& arc, const PeVector& o) {
  std::vector<numbers::Interval> sum(5), y(3);
  const auto add = [&](double coordinate, const auto& point, double sign) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = point(i) - numbers::Interval(coordinate) * arc.weights[i];
    }
    const auto term = squared(y);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = sum[i] + numbers::Interval(sign) * term[i];
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    add(
        o.m[int(k)], [&](std::size_t i) { return arc.centers[i][k]; }, 1);
  }
  add(
      o.r, [&](std::size_t i) { return arc.radii[i]; }, -1);
  const auto weights = squared(arc.weights);
  const numbers::Interval at_start = sum[0];
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] = sum[i] - at_start * weights[i];
  }
  return sum;
}

// (<x - o, x'> / v)' for x = p / w and the speed v of its centres: w^3 <x - o, x'> is w q'/2 - w'
// q.
numbers::Interval off_center(const ArcSpheres& arc, const PeVector& o, const numbers::Interval& t,
                             const numbers::Interval& v, const numbers::Interval& v1) {
  const auto w = numbers::bezier_jet(arc.weights, t),
             q = numbers::bezier_jet(off_sphere(arc, o), t);
  const numbers::Interval off = w[0] * q[1] / 2 - w[1] * q[0];
  const numbers::Interval change = (w[0] * q[2] - w[1] * q[1]) / 2 - w[2] * q[0];
  const numbers::Interval growth = numbers::Interval(3) * w[1] / w[0] + v1 / v;
  return (change - off * growth) / (w[0] * square(w[0]) * v);
}

}  // namespace

// Circles about c = m - r s n across n, of radius r sqrt(1 - s^2), for spheres (m; r) with v =
// |m'|, n = m' / v and s = r' / v. There is nothing to cancel in
//   n' = k (tangent x d) x n / (w^3 v^2),  s' = k n.(d_r tangent - tangent_r d) / (w^3 v^2),
//   c' = (v (1 - s^2) - r s') n - r s n',
// which are tighter where the circle hardly turns; the derivatives of m / |m| elsewhere. With any
// o = (o_m; o_r), too, c'.n = (<x - o, x'>/v)' - (m - o_m).n' - o_r s', as (m - o_m).n - (r - o_r)
// s = <x - o, x'>/v for x = (m; r). For the arc's own centre this is 0 but for what was rounded,
// and on straight arcs one term is left.
std::optional<MovingDisc> moving_disc(const CyclidePiece& piece, const numbers::Interval& t,
                                      double wall) {
  const ArcSpheres arc(piece);
  const numbers::Interval two = 2, first = piece.first.r;
  const auto w = numbers::bezier_jet(arc.weights, t), s = numbers::bezier_jet(arc.radii, t);
  const auto p = numbers::bezier_jet(arc.centers, t);
  if (!(w[0].lower > 0)) {
    return std::nullopt;
  }
  const numbers::Interval over_w = numbers::Interval(1) / w[0];
  const numbers::IntervalVec m = over_w * p[0], m1 = over_w * (p[1] - w[1] * m);
  const numbers::IntervalVec m2 = over_w * (p[2] - two * w[1] * m1 - w[2] * m);
  const numbers::Interval rise = over_w * s[0], r1 = over_w * (s[1] - w[1] * rise);
  const numbers::Interval r2 = over_w * (s[2] - two * w[1] * r1 - w[2] * rise);
  const numbers::Interval r = first + rise - wall;
  const numbers::Interval v2 = square(m1[0]) + square(m1[1]) + square(m1[2]);
  const numbers::Interval pace2 = numbers::intersection(
      v2 - square(r1), numbers::bezier_range(squared_pace(arc), t) / square(square(w[0])));
  if (!(v2.lower > 0 && pace2.lower > 0)) {
    return std::nullopt;
  }
  const numbers::Interval v = numbers::sqrt(v2), slope = r1 / v, set_back = r * slope,
                          q = set_back / v, v1 = numbers::dot(m1, m2) / v;
  const numbers::Interval q1 = (square(r1) + r * r2 - two * q * numbers::dot(m1, m2)) / v2;
  const numbers::IntervalVec normal = numbers::Interval(1) / v * m1;
  const numbers::Interval rate = arc.k / (w[0] * square(w[0]) * v2);
  const numbers::IntervalVec turning =
      numbers::intersection(numbers::Interval(1) / v * (m2 - numbers::dot(normal, m2) * normal),
                            rate * numbers::cross(numbers::cross(arc.tangent, arc.d), normal));
  const numbers::Interval bend =
      rate *
      numbers::dot(normal, arc.dr * arc.tangent - numbers::Interval(piece.tangent.r) * arc.d);
  numbers::Interval advance = v * (numbers::Interval(1) - square(slope)) - r * bend;
  if (const auto o = center_of_arc(piece)) {
    advance =
        numbers::intersection(advance, off_center(arc, *o, t, v, v1) -
                                           numbers::dot(m - numbers::interval_vec(o->m), turning) -
                                           (first + o->r - wall) * bend);
  }
  return MovingDisc{numbers::interval_vec(piece.first.m) + (m - set_back * normal), normal,
                    numbers::intersection((numbers::Interval(1) - q1) * m1 - q * m2,
                                          advance * normal - set_back * turning),
                    turning, r * numbers::sqrt(pace2) / v};
}

std::optional<MovingDisc> moving_disc(const RationalRingedSurface& surface,
                                      const numbers::Interval& t, bool steered) {
  const bool start = steered && t.lower == 0 && rests(surface, End::start);
  const bool end = steered && t.upper == 1 && rests(surface, End::end);
  std::vector<numbers::IntervalVec> points;
  for (const Vec3& point : surface.center) {
    points.push_back(numbers::interval_vec(point));
  }
  numbers::Quaternion<numbers::Interval> a, a1;
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<numbers::Interval> numbers;
    for (const auto& control : surface.rotation) {
      numbers.emplace_back(control[part]);
    }
    a[part] = numbers::bezier_range(numbers, t);
    a1[part] = rate(numbers, t, start, end);
  }
  const numbers::IntervalVec n = axis_of(a, a), n1 = axis_of(a1, a) + axis_of(a, a1);
  const numbers::Interval length = numbers::norm(n);
  if (!(length.lower > 0)) {
    return std::nullopt;
  }
  const numbers::IntervalVec normal = numbers::Interval(1) / length * n;
  return MovingDisc{
      numbers::bezier_range(points, t), normal, rate(points, t, start, end),
      numbers::Interval(1) / length * (n1 - numbers::dot(normal, n1) * normal),
      numbers::bezier_range(
          std::vector<numbers::Interval>(surface.radius.begin(), surface.radius.end()), t)};
}

DiscPace pace(const MovingDisc& disc, double width) {
  return {numbers::dot(disc.velocity, disc.normal).lower,
          numbers::norm(numbers::cross(disc.velocity, disc.normal)).upper,
          numbers::norm(disc.turning).upper, disc.radius, width};
}

bool advances(const std::vector<DiscPace>& way) {
  numbers::Interval phi = 0, radius = 0;
  for (const DiscPace& stretch : way) {
    phi = phi + numbers::Interval(stretch.width) * stretch.turning;
    radius = {0, std::max(radius.upper, stretch.radius.upper)};
  }
  phi = phi.upper;
  radius = radius.upper;
  const numbers::Interval cosine = numbers::Interval(1) - square(phi) / 2;
  return phi.upper < 1 && std::all_of(way.begin(), way.end(), [&](const DiscPace& stretch) {
           return stretch.radius.lower > 0 &&
                  (stretch.advance * cosine - stretch.sideways * phi - radius * stretch.turning)
                          .lower > 0;
         });
}

}  // namespace dupin::surfaces
