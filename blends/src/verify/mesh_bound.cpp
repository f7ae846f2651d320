#include "mesh_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../mpfi_interval.h"

namespace dupin::verifier {
namespace {

using Mpfi = detail::MpfiInterval<128>;

constexpr int kRefinements = 10;  // a band's bounds are taken over up to 2^10 cells

Mpfi wide(const Interval& x) { return Mpfi::between(x.lower, x.upper); }

Interval narrowed(const Mpfi& x) {
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

// Upper bounds, over a stretch, of |x_tt|, |x_tu|, |x_uu| in a frame that does not spin, and |T'|.
struct Bounds {
  double along = 0, mixed = 0, around = 0, turning = 0;
};

// Encloses value and first derivatives by t of a polynomial on [from, to].
template <std::size_t count>
std::array<Interval, count> jet(Polynomial p, double from, double to) {
  std::array<Interval, count> result;
  const mpq_class rate = 1 / (mpq_class(to) - mpq_class(from));
  for (Interval& value : result) {
    const auto [least, most] = std::minmax_element(p.begin(), p.end());
    value = hull(enclosed(*least), enclosed(*most));
    p = derivative(p);
    for (mpq_class& coefficient : p) {
      coefficient *= rate;
    }
  }
  return result;
}

// Radius and its derivatives, by R^2 + c R = r0 r1 with c = (r1 - r0) cos(pi t) for CyclideRadius:
// R' (2 R + c) = -c' R, R'' (2 R + c) = -c'' R - 2 c' R' - 2 R'^2.
std::array<Interval, 3> radius_jet(const Tube& tube, double from, double to) {
  const auto* law = std::get_if<CyclideRadius>(&tube.surface().radius);
  if (law == nullptr) {
    return jet<3>(tube.radius(from, to), from, to);
  }
  const Mpfi pi = Mpfi::pi(), t = Mpfi::between(from, to), rise = Mpfi(law->end) - law->start;
  const Mpfi r = wide(tube.radius_range(from, to));
  const Mpfi c = rise * cosine(pi * t), c1 = Mpfi(0) - pi * rise * sine(pi * t);
  const Mpfi root = 2 * r + c;  // = sqrt(c^2 + 4 r0 r1)
  const Mpfi r1 = (Mpfi(0) - c1 * r) / root;
  const Mpfi r2 = (pi * pi * c * r - 2 * c1 * r1 - 2 * square(r1)) / root;
  return {narrowed(r), narrowed(r1), narrowed(r2)};
}

// y', y'', y''' by t.
std::array<IntervalVec, 3> spine_jet(const Tube& tube, double from, double to) {
  std::array<IntervalVec, 3> result;
  const Stretch s = tube.stretch(from, to);
  const auto w = jet<4>(s.weight, from, to);
  for (std::size_t k = 0; k < 3; ++k) {
    // About the first point; the derivatives of w y = p.
    Polynomial p = s.points[k];
    const mpq_class first = p.front() / s.weight.front();
    p = difference(p, product(s.weight, {first}));
    const auto d = jet<4>(p, from, to);
    const Interval y = d[0] / w[0], y1 = (d[1] - w[1] * y) / w[0];
    const Interval y2 = (d[2] - Interval(2) * w[1] * y1 - w[2] * y) / w[0];
    const Interval three = 3;
    result[0][k] = y1;
    result[1][k] = y2;
    result[2][k] = (d[3] - three * w[1] * y2 - three * w[2] * y1 - w[3] * y) / w[0];
  }
  return result;
}

struct Motion {
  Interval speed, acceleration, turning, turning_change;
};

// T' = (y'' - v' T) / v, and the part of T'' across T is that of y'''/v - 2 (v'/v^2) y''.
Motion motion(const Tube& tube, double from, double to) {
  if (const ArcSpine* arc = tube.arc()) {
    const IntervalVec spoke = detail::interval_vec(arc->start) - detail::interval_vec(arc->center);
    return {norm(spoke) * arc->angle, 0, arc->angle, 0};
  }
  const auto [y1, y2, y3] = spine_jet(tube, from, to);
  const Interval speed = norm(y1);
  if (!(speed.lower > 0)) {
    return {0, 0, 0, 0};
  }
  const Interval acceleration = dot(y1, y2) / speed;
  const IntervalVec change =
      Interval(1) / speed * y3 - Interval(2) * acceleration / square(speed) * y2;
  return {speed, acceleration, norm(cross(y1, y2)) / square(speed),
          norm(cross(change, y1)) / speed};
}

// x_tt = (v' - 2 R' e.T' - R e.T'') T + (v - R e.T') T' + R'' e, x_tu = R' e_u - R (e_u.T') T.
bool include(Bounds& bounds, const Tube& tube, double from, double to) {
  const Motion y = motion(tube, from, to);
  const auto [r, r1, r2] = radius_jet(tube, from, to);
  if (!(y.speed.lower > 0)) {
    return false;
  }
  const Interval turn = y.turning.upper, slope = r1.magnitude(), radius = r.upper;
  const Interval lengthwise = Interval(y.acceleration.magnitude()) + Interval(2) * slope * turn +
                              radius * y.turning_change.upper;
  const Interval across = (Interval(y.speed.upper) + radius * turn) * turn + r2.magnitude();
  bounds.along = std::max(bounds.along, sqrt(square(lengthwise) + square(across)).upper);
  bounds.mixed = std::max(bounds.mixed, sqrt(square(slope) + square(radius * turn)).upper);
  bounds.around = std::max(bounds.around, radius.upper);
  bounds.turning = std::max(bounds.turning, turn.upper);
  return true;
}

// The design of the bound is in docs/certificate_format.md: linear interpolation on right triangles
// with legs dt and du, du widened by the frame's drift over a band and the tube's share of twist.
bool band_follows(const Tube& tube, double from, double to, std::uint32_t segments,
                  const Interval& twist, double allowed) {
  const Interval dt = Interval(to) - from;
  const Enclosure pi = Mpfi::pi().rounded_outward();
  const Interval around = Interval(2) * Interval(pi.lower, pi.upper) / segments;
  for (int cells = 1; cells <= 1 << kRefinements; cells *= 2) {
    Bounds bounds;
    bool moves = true;
    for (int i = 0; i < cells && moves; ++i) {
      const double a = i == 0 ? from : std::lerp(from, to, double(i) / cells);
      const double b = i + 1 == cells ? to : std::lerp(from, to, double(i + 1) / cells);
      moves = include(bounds, tube, a, b);
    }
    const Interval turn = dt * bounds.turning;
    const Interval du = around + twist + Interval(0.27) * square(turn) / 16;
    const Interval error = (square(dt) * bounds.along + Interval(2) * dt * du * bounds.mixed +
                            square(du) * bounds.around) /
                           8;
    if (moves && turn.upper <= 1 && error.upper <= allowed) {
      return true;
    }
  }
  return false;
}

// What snapping to the grid and the rounding of coordinates of this size may add.
Interval displacement(double grid, double size) {
  return sqrt(3) / 2 * grid + Interval(std::ldexp(size, -47));
}

bool is_straight(const Tube& tube) {
  const RingedSurface& s = tube.surface();
  return std::holds_alternative<LineSpine>(s.spine) && s.end.normal == -s.start.normal &&
         (std::holds_alternative<ConstantRadius>(s.radius) ||
          std::holds_alternative<LinearRadius>(s.radius));
}

}  // namespace

bool mesh_follows(const Tube& tube, const MeshClaim& claim) {
  const auto& knots = claim.knots;
  if (claim.segments < 3 || knots.size() < 2 || knots.front() != 0 || knots.back() != 1 ||
      std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) != knots.end()) {
    return false;
  }
  const Discs whole = tube.discs(0, 1);
  double size = whole.radius.upper;
  for (const IntervalVec& center : whole.centers) {
    size = std::max(size, norm(center).upper);
  }
  const double allowed = (Interval(claim.error_bound) - displacement(claim.grid, size)).lower;
  const Mpfi pi = Mpfi::pi(), segments = double(claim.segments);
  if (is_straight(tube) && knots.size() == 2) {
    const Mpfi sagitta = wide(whole.radius) * (1 - cosine(pi / segments));
    return sagitta.rounded_outward().upper <= allowed;
  }
  const Enclosure twist = (pi / segments / double(knots.size() - 1)).rounded_outward();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (!band_follows(tube, knots[i], knots[i + 1], claim.segments, {twist.lower, twist.upper},
                      allowed)) {
      return false;
    }
  }
  return true;
}

// No point of a facet of the graticule is nearer to the centre than its plane.
bool mesh_follows(const Sphere& sphere, const MeshClaim& claim) {
  if (claim.segments < 3 || !claim.knots.empty()) {
    return false;
  }
  const std::uint32_t bands = (claim.segments + 1) / 2;
  const Mpfi step = Mpfi::pi() / double(bands);
  const Mpfi half = cosine(Mpfi::pi() / double(claim.segments));
  double nearest = 1;
  for (std::uint32_t i = 0; i < bands; ++i) {
    const Mpfi a = step * double(i), b = step * double(i + 1);
    const Mpfi xa = half * sine(a), xb = half * sine(b), za = cosine(a), zb = cosine(b);
    const Mpfi plane =
        magnitude(xa * zb - xb * za) / square_root(square(xb - xa) + square(zb - za));
    nearest = std::min(nearest, plane.rounded_outward().lower);
  }
  const Interval sag = Interval(sphere.radius) * (Interval(1) - nearest);
  const double size = std::max(sphere.radius, sphere.center.norm());
  return (sag + displacement(claim.grid, size)).upper <= claim.error_bound;
}

}  // namespace dupin::verifier
