#include "surfaces/cyclide_discs.h"

#include <cmath>
#include <functional>

#include "numbers/bezier.h"

namespace dupin::surfaces {
namespace {

using numbers::Interval;
using numbers::IntervalVec;

using Bernstein = std::vector<Interval>;

// All sines and cosines, however wide the intervals are that they are computed from.
Interval sines() { return {-1, 1}; }

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
Bernstein squared(const Bernstein& p) {
  return {square(p[0]), p[0] * p[1], (p[0] * p[2] + Interval(2) * square(p[1])) / 3, p[1] * p[2],
          square(p[2])};
}

// <p, p> of four quadratic coordinates.
Bernstein minkowski_square(const std::function<Bernstein(std::size_t)>& coordinate) {
  Bernstein sum(5);
  for (std::size_t k = 0; k < 4; ++k) {
    const Bernstein term = squared(coordinate(k));
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = k < 3 ? sum[i] + term[i] : sum[i] - term[i];
    }
  }
  return sum;
}

}  // namespace

CyclideDiscs::CyclideDiscs(const CyclidePiece& piece)
    : first_center_(numbers::interval_vec(piece.first.m)),
      tangent_(numbers::interval_vec(piece.tangent.m)),
      d_(numbers::interval_vec(piece.last.m) - first_center_),
      first_radius_(piece.first.r),
      tangent_r_(piece.tangent.r),
      dr_(Interval(piece.last.r) - piece.first.r),
      arc_center_(center_of_arc(piece)) {
  const Interval squared_chord = numbers::dot(d_, d_) - square(dr_), chord = piece.chord;
  const Interval along = numbers::dot(d_, tangent_) - dr_ * tangent_r_;
  const Interval last = squared_chord / square(chord), half = squared_chord / (2 * chord);
  weights_ = {1, along / chord, last};
  centers_ = {{}, half * tangent_, last * d_};
  radii_ = {0, half * tangent_r_, last * dr_};
  k_ = Interval(4) * half * last;
  const auto point = [&](std::size_t k, std::size_t i) {
    return k < 3 ? centers_[i][k] : radii_[i];
  };
  // p' w - p w' is quadratic.
  squared_pace_ = minkowski_square([&](std::size_t k) {
    return Bernstein{2 * (weights_[0] * point(k, 1) - weights_[1] * point(k, 0)),
                     weights_[0] * point(k, 2) - weights_[2] * point(k, 0),
                     2 * (weights_[1] * point(k, 2) - weights_[2] * point(k, 1))};
  });
  if (arc_center_) {
    const PeVector& o = *arc_center_;
    off_sphere_ = minkowski_square([&](std::size_t k) {
      Bernstein y;
      for (std::size_t i = 0; i < 3; ++i) {
        y.push_back(point(k, i) - Interval(k < 3 ? o.m[int(k)] : o.r) * weights_[i]);
      }
      return y;
    });
    const Bernstein squared_weights = squared(weights_);
    const Interval at_start = off_sphere_[0];
    for (std::size_t i = 0; i < off_sphere_.size(); ++i) {
      off_sphere_[i] = off_sphere_[i] - at_start * squared_weights[i];
    }
  }
}

// (<x - o, x'> / v)' for x = p / w and the speed v of its centres: w^3 <x - o, x'> is w q'/2 - w'
// q.
Interval CyclideDiscs::off_center(const Interval& t, const Interval& v, const Interval& v1) const {
  const auto w = numbers::bezier_jet(weights_, t), q = numbers::bezier_jet(off_sphere_, t);
  const Interval off = w[0] * q[1] / 2 - w[1] * q[0];
  const Interval change = (w[0] * q[2] - w[1] * q[1]) / 2 - w[2] * q[0];
  const Interval growth = Interval(3) * w[1] / w[0] + v1 / v;
  return (change - off * growth) / (w[0] * square(w[0]) * v);
}

// Circles about c = m - r s n across n, of radius r sqrt(1 - s^2), for spheres (m; r) with v =
// |m'|, n = m' / v and s = r' / v. There is nothing to cancel in
//   n' = k (tangent x d) x n / (w^3 v^2),  s' = k n.(d_r tangent - tangent_r d) / (w^3 v^2),
//   c' = (v (1 - s^2) - r s') n - r s n',
// which are tighter where the circle hardly turns; the derivatives of m / |m| elsewhere. With any
// o = (o_m; o_r), too, c'.n = (<x - o, x'>/v)' - (m - o_m).n' - o_r s', as (m - o_m).n - (r - o_r)
// s = <x - o, x'>/v for x = (m; r). For the arc's own centre this is 0 but for what was rounded,
// and on straight arcs one term is left.
std::optional<MovingDisc> CyclideDiscs::over(const Interval& t, double wall) const {
  const Interval two = 2;
  const auto w = numbers::bezier_jet(weights_, t), s = numbers::bezier_jet(radii_, t);
  const auto p = numbers::bezier_jet(centers_, t);
  if (!(w[0].lower > 0)) {
    return std::nullopt;
  }
  const Interval over_w = Interval(1) / w[0];
  const IntervalVec m = over_w * p[0], m1 = over_w * (p[1] - w[1] * m);
  const IntervalVec m2 = over_w * (p[2] - two * w[1] * m1 - w[2] * m);
  const Interval rise = over_w * s[0], r1 = over_w * (s[1] - w[1] * rise);
  const Interval r2 = over_w * (s[2] - two * w[1] * r1 - w[2] * rise);
  const Interval r = first_radius_ + rise - wall;
  const Interval v2 = square(m1[0]) + square(m1[1]) + square(m1[2]);
  const Interval pace2 = numbers::intersection(
      v2 - square(r1), numbers::bezier_range(squared_pace_, t) / square(square(w[0])));
  if (!(v2.lower > 0 && pace2.lower > 0)) {
    return std::nullopt;
  }
  const Interval v = numbers::sqrt(v2), slope = numbers::intersection(r1 / v, sines()),
                 set_back = r * slope, q = set_back / v, v1 = numbers::dot(m1, m2) / v;
  const Interval q1 = (square(r1) + r * r2 - two * q * numbers::dot(m1, m2)) / v2;
  const IntervalVec normal =
      numbers::intersection(Interval(1) / v * m1, IntervalVec{sines(), sines(), sines()});
  const Interval rate = k_ / (w[0] * square(w[0]) * v2);
  const IntervalVec turning =
      numbers::intersection(Interval(1) / v * (m2 - numbers::dot(normal, m2) * normal),
                            rate * numbers::cross(numbers::cross(tangent_, d_), normal));
  const Interval bend = rate * numbers::dot(normal, dr_ * tangent_ - tangent_r_ * d_);
  Interval advance = v * (Interval(1) - square(slope)) - r * bend;
  if (const auto& o = arc_center_) {
    advance = numbers::intersection(
        advance, off_center(t, v, v1) - numbers::dot(m - numbers::interval_vec(o->m), turning) -
                     (first_radius_ + o->r - wall) * bend);
  }
  return MovingDisc{first_center_ + (m - set_back * normal), normal,
                    numbers::intersection((Interval(1) - q1) * m1 - q * m2,
                                          advance * normal - set_back * turning),
                    turning, r * numbers::intersection(numbers::sqrt(pace2) / v, sines())};
}

}  // namespace dupin::surfaces
