#include "dupin/blends/pe_arc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "cyclide/complementary_sphere.h"
#include "cyclide/exact_pe.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/interval.h"

namespace dupin {
namespace {

// V1 to V4, each freed of its roots, so that rational arithmetic decides it. With D = <d, d> = L^2,
// e = <d, T0>:
//   V2  e / L > -1                       <=>  e > -sqrt(D)
//   V3  e r0 / L + L tau / 2 > -sqrt(..) <=>  e r0 + D tau / 2 > -sqrt(D r0 r2)
//   V4  times |A|^2:  (|Dm|^2 + r0^2 - r2^2) |A|^2 + 2 r0 tau (A.Dm) > 2 r0 sqrt(|A|^2 |Dm|^2 -
//   (A.Dm)^2)
//
// Rational arithmetic takes twenty times as long as intervals of doubles, which decide nearly all:
// none where they do not.
std::optional<ArcFault> certain_fault(const PeVector& start, const PeVector& tangent,
                                      const PeVector& end) {
  const numbers::Interval r0 = start.r, r2 = end.r, tau = tangent.r, two = 2;
  const numbers::IntervalVec dm = numbers::interval_vec(end.m) - numbers::interval_vec(start.m),
                             along_start = numbers::interval_vec(tangent.m);
  const numbers::Interval dr = r2 - r0, dm2 = numbers::dot(dm, dm),
                          along = numbers::dot(dm, along_start),
                          a2 = numbers::dot(along_start, along_start);
  const numbers::Interval dd = dm2 - square(dr), e = along - dr * tau;
  // In the order of the faults, each positive where there is none.
  const auto is_open = [](const numbers::Interval& x) { return !(x.lower > 0 || x.upper < 0); };
  if (is_open(dd)) {
    return std::nullopt;
  }
  if (dd.upper < 0) {
    return ArcFault::nested;
  }
  const numbers::Interval infinity = e + sqrt(dd),
                          radius = e * r0 + dd * tau / two + sqrt(dd * r0 * r2);
  const numbers::Interval power = (dm2 + square(r0) - square(r2)) * a2 + two * r0 * tau * along,
                          across = two * r0 * sqrt(max(0, a2 * dm2 - square(along)));
  for (const auto& [margin, fault] : {std::pair(infinity, ArcFault::through_infinity),
                                      {radius, ArcFault::radius_vanishes},
                                      {power - across, ArcFault::pinched}}) {
    if (is_open(margin)) {
      return std::nullopt;
    }
    if (margin.upper < 0) {
      return fault;
    }
  }
  return ArcFault::none;
}

ArcFault exact_fault(const PeVector& start, const PeVector& tangent, const PeVector& end) {
  const auto b0 = cyclide::exact(start), t0 = cyclide::exact(tangent), b2 = cyclide::exact(end);
  const auto [dm, dr] = b2 - b0;
  const mpq_class dm2 = dot(dm, dm), along = dot(dm, t0.m), a2 = dot(t0.m, t0.m);
  const mpq_class dd = dm2 - dr * dr, e = along - dr * t0.r;
  if (dd <= 0) {
    return ArcFault::nested;
  }
  if (!cyclide::exceeds_negative_root(e, dd)) {
    return ArcFault::through_infinity;
  }
  if (!cyclide::exceeds_negative_root(e * b0.r + dd * t0.r / 2, dd * b0.r * b2.r)) {
    return ArcFault::radius_vanishes;
  }
  const mpq_class power = (dm2 + b0.r * b0.r - b2.r * b2.r) * a2 + 2 * b0.r * t0.r * along;
  const mpq_class across = 4 * b0.r * b0.r * (a2 * dm2 - along * along);
  return power > 0 && power * power > across ? ArcFault::none : ArcFault::pinched;
}

void require_finite(const PeVector& start, const PeVector& tangent, const PeVector& end) {
  for (const PeVector* given : {&start, &tangent, &end}) {
    if (!given->m.allFinite() || !std::isfinite(given->r)) {
      throw Error(Errc::invalid_argument, "spheres and tangent must be finite numbers");
    }
  }
}

// The fault is decided exactly; the rounded number may lie on the other side, and is not said then.
std::string fails(const std::string& what, double value, double bound) {
  const std::string must = bound == 0 ? " must be positive" : " must exceed -1";
  return value <= bound ? what + (bound == 0 ? " " : " = ") + decimal(value, kMessageDigits) + must
                        : what + must;
}

std::string explain(const ArcValidity& v) {
  switch (v.fault) {
    case ArcFault::none:
      break;
    case ArcFault::nested:
      return "no cyclide piece: one end sphere contains the other (" +
             fails("squared tangential distance", v.squared_length, 0) +
             "): move them apart or make the radii more alike";
    case ArcFault::through_infinity:
      return "no cyclide piece: the end sphere lies behind the start direction (" +
             fails("w", v.w, -1) + "): insert an intermediate sphere";
    case ArcFault::radius_vanishes:
      return "no cyclide piece: the radius would pass through zero (" +
             fails("margin", v.radius_margin, 0) + "): reduce the start slope or insert a sphere";
    case ArcFault::pinched:
      return "no cyclide piece: the bend is too tight for its radius (" +
             fails("least power", v.least_power, 0) + "): move the end sphere further away";
  }
  return "no cyclide piece";
}

HomogeneousSphere blossom(const PeArc& arc, double t) {
  const auto p = bezier_points(arc);
  const double b0 = (1 - t) * (1 - t), b1 = 2 * t * (1 - t), b2 = t * t;
  return {b0 * p[0].sphere + b1 * p[1].sphere + b2 * p[2].sphere,
          b0 * p[0].weight + b1 * p[1].weight + b2 * p[2].weight};
}

}  // namespace

PeVector operator+(const PeVector& a, const PeVector& b) { return {a.m + b.m, a.r + b.r}; }
PeVector operator-(const PeVector& a, const PeVector& b) { return {a.m - b.m, a.r - b.r}; }
PeVector operator*(double s, const PeVector& a) { return {s * a.m, s * a.r}; }

double product(const PeVector& a, const PeVector& b) { return a.m.dot(b.m) - a.r * b.r; }

double squared_tangential_distance(const PeVector& a, const PeVector& b) {
  const double distance = (a.m - b.m).norm(), difference = a.r - b.r;
  return (distance - difference) * (distance + difference);
}

PeVector contact_sphere(const Ring& ring) {
  return {ring.center + ring.radius * ring.slope * ring.normal,
          ring.radius * std::hypot(1, ring.slope)};
}

PeVector contact_tangent(const Ring& ring) {
  return {std::hypot(1, ring.slope) * ring.normal, ring.slope};
}

Ring contact_ring(const PeVector& b, const PeVector& tangent) {
  const double stretch = std::hypot(1, tangent.r);
  return {b.m - b.r * tangent.r / (stretch * stretch) * tangent.m, tangent.m.normalized(),
          b.r / stretch, tangent.r};
}

ArcValidity rounded_validity(const PeVector& start, const PeVector& tangent, const PeVector& end) {
  ArcValidity v;
  const PeVector d = end - start;
  v.squared_length = squared_tangential_distance(start, end);
  const double length = std::sqrt(std::max(0.0, v.squared_length));
  v.w = length > 0 ? product(d, tangent) / length : 0;
  v.radius_margin =
      v.w * start.r + length / 2 * tangent.r + std::sqrt(std::max(0.0, start.r * end.r));
  const double stretch = tangent.m.norm();
  const Vec3 axis = tangent.m / stretch;
  const double along = axis.dot(d.m), across = (d.m - along * axis).norm();
  v.least_power = d.m.squaredNorm() + start.r * start.r - end.r * end.r -
                  2 * start.r * (across - tangent.r * along) / stretch;
  v.fault = !(v.squared_length > 0)  ? ArcFault::nested
            : !(v.w > -1)            ? ArcFault::through_infinity
            : !(v.radius_margin > 0) ? ArcFault::radius_vanishes
            : !(v.least_power > 0)   ? ArcFault::pinched
                                     : ArcFault::none;
  return v;
}

ArcValidity validity(const PeVector& start, const PeVector& tangent, const PeVector& end) {
  require_finite(start, tangent, end);
  ArcValidity v = rounded_validity(start, tangent, end);
  const auto certain = certain_fault(start, tangent, end);
  v.fault = certain ? *certain : exact_fault(start, tangent, end);
  return v;
}

PeArc PeArc::from(const PeVector& start, const PeVector& tangent, const PeVector& end) {
  require_finite(start, tangent, end);
  if (start.r <= 0 || end.r <= 0) {
    throw Error(Errc::invalid_argument, "the radii of a chain's spheres must be positive");
  }
  const ArcValidity v = validity(start, tangent, end);
  if (v.fault != ArcFault::none) {
    throw Error(Errc::infeasible_blend, explain(v));
  }
  PeArc arc;
  arc.start_ = start;
  arc.start_tangent_ = tangent;
  arc.end_ = end;
  arc.chord_ = std::sqrt(v.squared_length);
  arc.w_ = v.w;
  arc.least_power_ = v.least_power;
  // Normalised again, so that rounding does not add up along a chain.
  const PeVector t2 = (2 * v.w / arc.chord_) * (end - start) - tangent;
  arc.end_tangent_ = (1 / std::sqrt(product(t2, t2))) * t2;
  if (!std::isfinite(arc.chord_) || !std::isfinite(arc.w_) || !std::isfinite(arc.least_power_) ||
      !arc.end_tangent_.m.allFinite() || !std::isfinite(arc.end_tangent_.r)) {
    throw Error(Errc::invalid_argument,
                "the spheres of a chain are too large, too small or too far apart for doubles");
  }
  return arc;
}

std::array<HomogeneousSphere, 3> bezier_points(const PeArc& arc) {
  return {{{arc.start(), 1},
           {arc.w() * arc.start() + (arc.chord() / 2) * arc.start_tangent(), arc.w()},
           {arc.end(), 1}}};
}

PeVector sphere_at(const PeArc& arc, double t) {
  if (t == 0) {
    return arc.start();
  }
  if (t == 1) {
    return arc.end();
  }
  const HomogeneousSphere h = blossom(arc, t);
  return (1 / h.weight) * h.sphere;
}

PeVector tangent_at(const PeArc& arc, double t) {
  if (t == 0) {
    return arc.start_tangent();
  }
  if (t == 1) {
    return arc.end_tangent();
  }
  const auto p = bezier_points(arc);
  const HomogeneousSphere h = blossom(arc, t);
  const PeVector slope =
      (2 * (1 - t)) * (p[1].sphere - p[0].sphere) + (2 * t) * (p[2].sphere - p[1].sphere);
  const double weight_slope = 2 * (1 - t) * (arc.w() - 1) + 2 * t * (1 - arc.w());
  const PeVector direction = slope - (weight_slope / h.weight) * h.sphere;
  return (1 / std::sqrt(product(direction, direction))) * direction;
}

Ring circle_at(const PeArc& arc, double t) {
  return contact_ring(sphere_at(arc, t), tangent_at(arc, t));
}

double pe_length(const PeArc& arc) {
  // L acos(w) / sqrt(1 - w^2), written in x = 2 asin^2 form: with 1 - w = 2 s^2 both functions are
  // smooth through w = 1.
  const double w = arc.w();
  const double rest = (1 - w) * (1 + w);
  if (w < 1) {
    const double half = std::asin(std::sqrt((1 - w) / 2));
    return half == 0 ? arc.chord() : arc.chord() * 2 * half / std::sqrt(rest);
  }
  const double half = std::asinh(std::sqrt((w - 1) / 2));
  return half == 0 ? arc.chord() : arc.chord() * 2 * half / std::sqrt(-rest);
}

PeArc sub_arc(const PeArc& arc, double a, double b) {
  if (!(0 <= a && a < b && b <= 1)) {
    throw Error(Errc::invalid_argument, "a part of an arc needs parameters 0 <= a < b <= 1");
  }
  return PeArc::from(sphere_at(arc, a), tangent_at(arc, a), sphere_at(arc, b));
}

PeArc reversed(const PeArc& arc) {
  return PeArc::from(arc.end(), -1 * arc.end_tangent(), arc.start());
}

PeArc offset(const PeArc& arc, double h) {
  const PeVector shift{Vec3::Zero(), h};
  return PeArc::from(arc.start() + shift, arc.start_tangent(), arc.end() + shift);
}

bool is_revolution(const PeArc& arc) {
  const Vec3 across = arc.start_tangent().m.normalized().cross(arc.end().m - arc.start().m);
  const double noise = 16 * std::numeric_limits<double>::epsilon() *
                       (arc.end().m.cwiseAbs() + arc.start().m.cwiseAbs()).sum();
  return across.norm() <= noise;
}

ArcFrame frame(const PeArc& arc) {
  const Vec3 axis = arc.start_tangent().m.normalized();
  Vec3 second = axis.cross(arc.end().m - arc.start().m);
  if (is_revolution(arc)) {
    int smallest = 0;
    axis.cwiseAbs().minCoeff(&smallest);
    second = Vec3::Unit(smallest) - axis(smallest) * axis;
  }
  second.normalize();
  return {axis, second.cross(axis), second};
}

ArcPoint point_at(const PeArc& arc, double t, double v) {
  const cyclide::ComplementarySphere q =
      cyclide::complementary_sphere(arc, frame(arc), 1, std::cos(v), std::sin(v));
  const HomogeneousSphere h = blossom(arc, t);
  const Vec3 position = (q.radius * h.sphere.m - h.sphere.r * q.center) /
                        (q.radius * h.weight - h.sphere.r * q.weight);
  const PeVector sphere = sphere_at(arc, t);
  return {position, (position - sphere.m).normalized()};
}

}  // namespace dupin
