#include "moving_disc.h"

#include <algorithm>
#include <vector>

#include "interval_bezier.h"
#include "quaternion.h"

namespace dupin::detail {
namespace {

// Bernstein coefficients of a polynomial that t divides, over t.
template <class T>
std::vector<T> over_t(const std::vector<T>& p) {
  std::vector<T> q;
  const auto degree = static_cast<double>(p.size() - 1);
  for (std::size_t i = 1; i < p.size(); ++i) {
    q.push_back(Interval(degree) / double(i) * p[i]);
  }
  return q;
}

// The derivative of a Bezier polynomial on t, over t or 1 - t if `start` or `end`, where it must
// vanish.
template <class T>
T rate(const std::vector<T>& points, const Interval& t, bool start, bool end) {
  std::vector<T> difference;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    difference.push_back(Interval(double(points.size() - 1)) * (points[i + 1] - points[i]));
  }
  if (start) {
    difference = over_t(difference);
  } else if (end) {
    std::reverse(difference.begin(), difference.end());
    difference = over_t(difference);
    std::reverse(difference.begin(), difference.end());
  }
  return bezier_range(difference, t);
}

bool rests(const RationalRingedSurface& surface, bool at_end) {
  const auto& [center, radius, rotation] = surface;
  return at_end ? center[3] == center[2] && rotation.back() == rotation[rotation.size() - 2]
                : center[0] == center[1] && rotation[0] == rotation[1];
}

IntervalVec axis_of(const Quaternion<Interval>& a, const Quaternion<Interval>& b) {
  const Quaternion<Interval> unit{0, 1, 0, 0};
  const auto n = product(product(a, unit), conjugate(b));
  return {n[1], n[2], n[3]};
}

}  // namespace

// Circles about c = m - q m' with q = r r' / |m'|^2, across m', for spheres (m; r) = p / w.
std::optional<MovingDisc> moving_disc(const CyclidePiece& piece, const Interval& t, double wall) {
  const IntervalVec base = interval_vec(piece.first.m), tangent = interval_vec(piece.tangent.m);
  const IntervalVec d = interval_vec(piece.last.m) - base;
  const Interval dr = Interval(piece.last.r) - piece.first.r, two = 2;
  const Interval squared = dot(d, d) - square(dr), chord = piece.chord;
  const Interval along = dot(d, tangent) - dr * piece.tangent.r;
  const Interval middle = along / chord, last = squared / square(chord);
  const Interval half = squared / (two * chord);
  const auto w = bezier_jet(std::vector<Interval>{1, middle, last}, t);
  const auto p = bezier_jet(std::vector<IntervalVec>{{}, half * tangent, last * d}, t);
  const auto s = bezier_jet(
      std::vector<Interval>{piece.first.r, middle * piece.first.r + half * piece.tangent.r,
                            last * piece.last.r},
      t);
  if (!(w[0].lower > 0)) {
    return std::nullopt;
  }
  const Interval over_w = Interval(1) / w[0];
  const IntervalVec m = over_w * p[0], m1 = over_w * (p[1] - w[1] * m);
  const IntervalVec m2 = over_w * (p[2] - two * w[1] * m1 - w[2] * m);
  const Interval full = over_w * s[0], r1 = over_w * (s[1] - w[1] * full);
  const Interval r2 = over_w * (s[2] - two * w[1] * r1 - w[2] * full), r = full - wall;
  const Interval v2 = square(m1[0]) + square(m1[1]) + square(m1[2]);
  if (!((v2 - square(r1)).lower > 0)) {
    return std::nullopt;
  }
  const Interval v = sqrt(v2), q = r * r1 / v2;
  const Interval q1 = (square(r1) + r * r2 - two * q * dot(m1, m2)) / v2;
  const IntervalVec normal = Interval(1) / v * m1;
  return MovingDisc{base + (m - q * m1), normal, (Interval(1) - q1) * m1 - q * m2,
                    Interval(1) / v * (m2 - dot(normal, m2) * normal),
                    r * sqrt(v2 - square(r1)) / v};
}

std::optional<MovingDisc> moving_disc(const RationalRingedSurface& surface, const Interval& t,
                                      bool steered) {
  const bool start = steered && t.lower == 0 && rests(surface, false);
  const bool end = steered && t.upper == 1 && rests(surface, true);
  std::vector<IntervalVec> points;
  for (const Vec3& point : surface.center) {
    points.push_back(interval_vec(point));
  }
  Quaternion<Interval> a, a1;
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<Interval> numbers;
    for (const auto& control : surface.rotation) {
      numbers.emplace_back(control[part]);
    }
    a[part] = bezier_range(numbers, t);
    a1[part] = rate(numbers, t, start, end);
  }
  const IntervalVec n = axis_of(a, a), n1 = axis_of(a1, a) + axis_of(a, a1);
  const Interval length = norm(n);
  if (!(length.lower > 0)) {
    return std::nullopt;
  }
  const IntervalVec normal = Interval(1) / length * n;
  return MovingDisc{
      bezier_range(points, t), normal, rate(points, t, start, end),
      Interval(1) / length * (n1 - dot(normal, n1) * normal),
      bezier_range(std::vector<Interval>(surface.radius.begin(), surface.radius.end()), t)};
}

DiscPace pace(const MovingDisc& disc, double width) {
  return {dot(disc.velocity, disc.normal).lower, norm(cross(disc.velocity, disc.normal)).upper,
          norm(disc.turning).upper, disc.radius, width};
}

bool advances(const std::vector<DiscPace>& way) {
  Interval phi = 0, radius = 0;
  for (const DiscPace& stretch : way) {
    phi = phi + Interval(stretch.width) * stretch.turning;
    radius = {0, std::max(radius.upper, stretch.radius.upper)};
  }
  phi = phi.upper;
  radius = radius.upper;
  const Interval cosine = Interval(1) - square(phi) / 2;
  return phi.upper < 1 && std::all_of(way.begin(), way.end(), [&](const DiscPace& stretch) {
           return stretch.radius.lower > 0 &&
                  (stretch.advance * cosine - stretch.sideways * phi - radius * stretch.turning)
                          .lower > 0;
         });
}

}  // namespace dupin::detail
