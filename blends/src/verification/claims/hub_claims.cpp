#include "verification/claims/hub_claims.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "verification/admitted.h"
#include "verification/claims/mesh_claim.h"
#include "verification/claims/pair_claims.h"
#include "verification/covering.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

const CyclidePiece* last_piece(const Solid& arm) {
  return arm.pieces().empty() ? nullptr : std::get_if<CyclidePiece>(&arm.pieces().back().shape);
}

// The end tangent (A; tau), times <d, d>.
struct EndTangent {
  std::array<Wide, 3> a;
  Wide tau;
};

EndTangent end_tangent(const CyclidePiece& piece) {
  std::array<Wide, 3> d;
  const Wide dr = Wide(piece.last.r) - piece.first.r;
  Wide squared = Wide(0) - square(dr), along = Wide(0) - dr * piece.tangent.r;
  for (int k = 0; k < 3; ++k) {
    d.at(std::size_t(k)) = Wide(piece.last.m[k]) - piece.first.m[k];
    squared = squared + square(d.at(std::size_t(k)));
    along = along + d.at(std::size_t(k)) * piece.tangent.m[k];
  }
  EndTangent result;
  for (int k = 0; k < 3; ++k) {
    result.a.at(std::size_t(k)) = 2 * along * d.at(std::size_t(k)) - squared * piece.tangent.m[k];
  }
  result.tau = 2 * along * dr - squared * piece.tangent.r;
  return result;
}

Wide squared_length(const EndTangent& t) {
  return square(t.a[0]) + square(t.a[1]) + square(t.a[2]);
}

// The cones of directions u with u.m' = -r' along a stretch: u = sine along + cosine across.
struct Directions {
  IntervalVec along;
  Interval sine, cosine;
};

std::optional<Directions> directions(const MovingSphere& sphere) {
  const IntervalVec m1 = part(sphere.center, 1);
  const Interval r1 = sphere.radius[1], speed = numbers::norm(m1);
  if (!((square(speed) - square(r1)).lower > 0) || !(sphere.radius[0].lower > 0)) {
    return std::nullopt;
  }
  const Interval sine = -r1 / speed;
  return Directions{(Interval(1) / speed) * m1, sine,
                    sqrt(max(Interval(0), Interval(1) - square(sine)))};
}

// What u.v may be, of `sign` across: from below with -1, from above with 1.
Interval extreme(const Directions& u, const IntervalVec& v, double sign) {
  return u.sine * numbers::dot(u.along, v) +
         Interval(sign) * u.cosine * numbers::norm(numbers::cross(u.along, v));
}

// Of the points m + r u the power with respect to the hub.
bool has_positive_power(const MovingSphere& sphere, const Directions& u,
                        const IntervalVec& from_hub, double hub_radius) {
  const IntervalVec d = part(sphere.center, 0) + from_hub;
  const Interval r = sphere.radius[0], rho = r - Interval(hub_radius);
  return (square(numbers::norm(d)) - square(rho) + Interval(2) * r * (extreme(u, d, -1) + rho))
             .lower > 0;
}

// Before the end in the hub it is (1 - t)^2 times |e|^2 - s^2 + 2 r (u.e' + s'), (e; s) being what
// the sphere is less the hub, divided by 1 - t: its product with (u; 1) is (1 - t) times that of
// (e'; s'), as u.m' + r' = 0.
bool comes_from_outside(const Interval& radius, const Directions& u, const MovingSphere& approach) {
  const IntervalVec e = part(approach.center, 0), e1 = part(approach.center, 1);
  return (square(numbers::norm(e)) - square(approach.radius[0]) +
          Interval(2) * radius * (extreme(u, e1, -1) + approach.radius[1]))
             .lower > 0;
}

}  // namespace

bool is_arm(const Solid& arm, const Sphere& hub) {
  const CyclidePiece* piece = last_piece(arm);
  return piece != nullptr && !arm.closed() && arm.is_full() && piece->last.m == hub.center &&
         piece->last.r == hub.radius;
}

// Circles {u.A = -tau} of unit vectors, whose caps {u.A < -tau} have the angular radii arccos(tau /
// |A|).
bool caps_are_disjoint(const Solid& one, const Solid& other) {
  spend(kWorkOfCaps);
  const EndTangent s = end_tangent(*last_piece(one)), t = end_tangent(*last_piece(other));
  const Wide ss = squared_length(s), tt = squared_length(t);
  const Wide between = s.a[0] * t.a[0] + s.a[1] * t.a[1] + s.a[2] * t.a[2] - s.tau * t.tau;
  const Wide s_root = ss - square(s.tau), t_root = tt - square(t.tau);
  const bool are_circles = s_root.is_positive() && t_root.is_positive();
  return are_circles && (s.tau * square_root(tt) + t.tau * square_root(ss)).is_positive() &&
         (Wide(0) - between - square_root(s_root * t_root)).is_positive();
}

bool keeps_outside(const Solid& arm, const ParameterInterval& t, const Sphere& hub) {
  const Piece* piece = arm.piece(t);
  const auto* shape = piece != nullptr ? std::get_if<CyclidePiece>(&piece->shape) : nullptr;
  if (shape == nullptr || !(t.from < t.to)) {
    return false;
  }
  const ParameterInterval within = within_piece(t);
  const SphereMotion spheres = sphere_motion(*shape, 0);
  const auto sphere = spheres(within.from, within.to);
  const auto u = sphere ? directions(*sphere) : std::nullopt;
  if (!u) {
    return false;
  }
  if (piece == &arm.pieces().back()) {
    const auto near = approach(*shape)(within.from, within.to);
    return near && comes_from_outside(sphere->radius[0], *u, *near);
  }
  return has_positive_power(
      *sphere, *u, numbers::interval_vec(shape->first.m) - numbers::interval_vec(hub.center),
      hub.radius);
}

namespace {

// Whether the disc's nearest point is further from there than the root of this.
bool is_further(const MovingDisc& disc, const IntervalVec& from, const Interval& squared) {
  const IntervalVec normal = part(disc.normal, 0), to = from - part(disc.center, 0);
  const Interval height = numbers::dot(to, normal);
  const Interval aside = numbers::norm(to - height * normal) - disc.radius[0];
  return (square(height) + square(max(aside, 0)) - squared).lower > 0;
}

bool is_behind(const MovingDisc& disc, const MovingDisc& last) {
  const IntervalVec normal = part(last.normal, 0);
  const Interval reach = Interval(disc.radius[0].magnitude()) *
                         numbers::norm(numbers::cross(part(disc.normal, 0), normal));
  return (numbers::dot(part(disc.center, 0) - part(last.center, 0), normal) + reach).upper <= 0;
}

}  // namespace

// What is in the hub and in front of the last circle's plane, is in every ball on the other side of
// which that circle is, whose centre is further ahead: |x - o|^2 - R^2 less 2 mu (x - c).n.
bool begins_outside(const Solid& arm, const Sphere& hub) {
  const WorkLimit not_counted(std::numeric_limits<std::uint64_t>::max());
  const auto& pieces = arm.pieces();
  const auto first = pieces.empty() ? std::nullopt : pieces.front().motion(0, 0);
  const auto last = pieces.empty() ? std::nullopt : pieces.back().motion(1, 1);
  if (!first || !last) {
    return false;
  }
  const IntervalVec normal = part(last->normal, 0), center = numbers::interval_vec(hub.center);
  const Interval ahead = numbers::dot(center - part(last->center, 0), normal);
  const double radii[] = {0, .25, .5, 1, 2, 4, 8, 16};
  return is_behind(*first, *last) || std::ranges::any_of(radii, [&](double radii_ahead) {
           const Interval mu = Interval(radii_ahead) * hub.radius;
           return is_further(*first, center + mu * normal,
                             square(Interval(hub.radius)) + square(mu) + Interval(2) * mu * ahead);
         });
}

bool follows_at_hub(const Solid& arm, const Sphere& hub, const ClearanceClaim& claim) {
  return has_form(claim) && claim.verdict == Verdict::proved && !claim.overlap &&
         claim.distance == 0 && claim.corner == 0 && begins_outside(arm, hub) &&
         covered({0, arm.length()}, {0, 1}, claim.leaves, false) &&
         std::all_of(claim.leaves.begin(), claim.leaves.end(), [&](const DiscPairs& leaf) {
           return !leaf.direction && is_stretch(leaf.first, arm.length()) &&
                  is_stretch(leaf.second, 1) && keeps_outside(arm, leaf.first, hub);
         });
}

// A triangle in a circle of the radius R sin(pi / n) is nowhere deeper than R (1 - cos(pi / n)). At
// a cap's circle the surface goes on as a collar; there points are off it by at most the root of
// that squared and of the sagitta's part along the sphere's radius squared, which is at most half.
bool follows_of_hub(const Sphere& hub, const MeshClaim& claim) {
  if (!is_bound(claim.grid) || !is_bound(claim.error_bound) || claim.segments < 3 ||
      claim.segments > CertificateLimits::kSegments || !claim.knots.empty() || claim.axes != 0 ||
      is_of_chain(claim)) {
    return false;
  }
  const Mpfi depth = Mpfi(hub.radius) * (1 - cosine(Mpfi::pi() / double(claim.segments)));
  const Interval error = Interval(depth.rounded_outward().upper) * sqrt(Interval(1.25));
  const double size = hub.radius + hub.center.norm() * (1 + 0x1p-40);
  return (error + displacement(claim.grid, size)).upper <= claim.error_bound;
}

}  // namespace dupin::verification
