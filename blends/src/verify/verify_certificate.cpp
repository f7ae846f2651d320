#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "../mpfi_interval.h"
#include "dupin/blends/certificate.h"
#include "dupin/kernel/error.h"
#include "mesh_bound.h"
#include "tube.h"

namespace dupin::verifier {
namespace {

using Mpfi = detail::MpfiInterval<1024>;
using MpfiVec = std::array<Mpfi, 3>;

// ---- (a): G = (1 - margin)^2 |y'|^6 - R^2 |y' x y''|^2 w^4 > 0 and R > 0

// The curvature as |y' x y''|^2 w^4 / |y'|^6, in the stretch's own parameter: it makes no
// difference.
struct Curvature {
  Polynomial above, below;
};

Polynomial square(const Polynomial& p) { return product(p, p); }

Curvature curvature(const Tube& tube, double from, double to) {
  if (const ArcSpine* arc = tube.arc()) {
    // The affine image of a circle: |y'|^2 is not below the least eigenvalue of its Gram matrix.
    Curve u, v;
    for (int k = 0; k < 3; ++k) {
      u[k] = {mpq_class(arc->start[k]) - mpq_class(arc->center[k])};
    }
    const Vec3& axis = arc->axis;
    v = cross(Curve{Polynomial{axis.x()}, Polynomial{axis.y()}, Polynomial{axis.z()}}, u);
    const mpq_class uu = dot(u, u)[0], vv = dot(v, v)[0], uv = dot(u, v)[0];
    const mpq_class least = std::min(uu, vv) - abs(uv);
    const Curve bend = cross(u, v);
    return {dot(bend, bend), {least * least * least}};
  }
  const Stretch s = tube.stretch(from, to);
  const Curve bend = cross(s.tangent, derivative(s.tangent));
  const Polynomial speed = dot(s.tangent, s.tangent);
  return {product(dot(bend, bend), square(square(s.weight))), product(speed, square(speed))};
}

Polynomial excess(const Tube& tube, double margin, double from, double to,
                  const Polynomial& radius) {
  const Curvature c = curvature(tube, from, to);
  const mpq_class room = 1 - mpq_class(margin);
  return difference(product({room * room}, c.below), product(square(radius), c.above));
}

bool all_positive(const Polynomial& p) {
  return std::all_of(p.begin(), p.end(), [](const mpq_class& x) { return x > 0; });
}

// A CyclideRadius is replaced by its largest value, on smaller stretches where that is too much.
bool is_regular_on(const Tube& tube, double margin, double from, double to, int halvings) {
  const Polynomial radius = tube.radius(from, to);
  if (!radius.empty()) {
    return all_positive(radius) && all_positive(excess(tube, margin, from, to, radius));
  }
  const Interval range = tube.radius_range(from, to);
  if (range.lower > 0 && all_positive(excess(tube, margin, from, to, {range.upper}))) {
    return true;
  }
  const double middle = (from + to) / 2;
  return halvings > 0 && is_regular_on(tube, margin, from, middle, halvings - 1) &&
         is_regular_on(tube, margin, middle, to, halvings - 1);
}

bool fails_at(const Tube& tube, double margin, double t) {
  const Polynomial radius = tube.radius(t, t);
  const double least = tube.radius_range(t, t).lower;
  return tube.arc() == nullptr && least > 0 &&
         excess(tube, margin, t, t, radius.empty() ? Polynomial{least} : radius).front() <= 0;
}

bool follows(const Tube& tube, const RegularClaim& claim) {
  if (!(claim.margin >= 0 && claim.margin < 1)) {
    return false;
  }
  if (claim.verdict == Verdict::refuted) {
    return 0 <= claim.where.from && claim.where.to <= 1 &&
           (fails_at(tube, claim.margin, claim.where.from) ||
            fails_at(tube, claim.margin, claim.where.to));
  }
  constexpr int kHalvings = 24;
  double reached = 0;
  for (const ParameterInterval& leaf : claim.leaves) {
    if (leaf.from != reached || !(leaf.from < leaf.to && leaf.to <= 1) ||
        !is_regular_on(tube, claim.margin, leaf.from, leaf.to, kHalvings)) {
      return false;
    }
    reached = leaf.to;
  }
  return reached == 1;
}

// ---- (c): the angles at the ends

Mpfi dot(const MpfiVec& a, const MpfiVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Mpfi length_of_cross(const MpfiVec& a, const MpfiVec& b) {
  const MpfiVec c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return square_root(dot(c, c));
}

struct EndMotion {
  MpfiVec first, second;
};

EndMotion motion_at(const Tube& tube, bool at_end) {
  EndMotion result;
  if (const ArcSpine* arc = tube.arc()) {
    const Mpfi turned = at_end ? arc->angle : 0, rate = arc->angle;
    const Mpfi c = cosine(turned), s = sine(turned);
    MpfiVec u, a;
    for (int k = 0; k < 3; ++k) {
      u[k] = Mpfi(arc->start[k]) - arc->center[k];
      a[k] = arc->axis[k];
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Mpfi v = a[i] * u[j] - a[j] * u[i];
      result.first[k] = rate * (c * v - s * u[k]);
      result.second[k] = Mpfi(0) - rate * rate * (c * u[k] + s * v);
    }
    return result;
  }
  // Exactly, from w y = p.
  const Stretch s = tube.stretch(0, 1);
  const auto value = [at_end](const Polynomial& p) { return at_end ? p.back() : p.front(); };
  const Polynomial w1 = derivative(s.weight);
  const mpq_class w = value(s.weight);
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial p1 = derivative(s.points[k]);
    const mpq_class y = value(s.points[k]) / w, y1 = (value(p1) - value(w1) * y) / w;
    const mpq_class y2 =
        (value(derivative(p1)) - 2 * value(w1) * y1 - value(derivative(w1)) * y) / w;
    result.first[k] = Mpfi(y1);
    result.second[k] = Mpfi(y2);
  }
  return result;
}

bool follows(const Tube& tube, const TangencyClaim& claim, bool at_end) {
  const EndMotion y = motion_at(tube, at_end);
  const Ring& ring = at_end ? tube.surface().end : tube.surface().start;
  const Mpfi outward = at_end ? 1 : -1, slope = outward * ring.slope;
  const MpfiVec normal{outward * ring.normal.x(), outward * ring.normal.y(),
                       outward * ring.normal.z()};
  const Polynomial radius = tube.radius(0, 1);
  const Polynomial slopes = radius.empty() ? Polynomial{0} : derivative(radius);
  const Mpfi rise{at_end ? slopes.back() : slopes.front()};
  const Mpfi reach = evaluate(tube.surface().radius, at_end ? 1 : 0).value;
  const Mpfi speed = square_root(dot(y.first, y.first));
  const Mpfi bend = reach * length_of_cross(y.first, y.second) / square(speed);
  const auto deviation = [&](const Mpfi& advance) {
    return angle(magnitude(rise - advance * slope), advance + rise * slope).rounded_outward().upper;
  };
  const double largest = std::max(deviation(speed - bend), deviation(speed + bend));
  const double axis =
      angle(length_of_cross(y.first, normal), dot(y.first, normal)).rounded_outward().upper;
  return axis <= claim.axis_angle &&
         ((speed - bend).is_positive() ? largest : 4) <= claim.deviation;
}

// ---- (b) and (e): pairs of discs

using Pairs = std::vector<const DiscPairs*>;

bool contains(const ParameterInterval& outer, const ParameterInterval& inner) {
  return outer.from <= inner.from && inner.to <= outer.to;
}

bool meet(const ParameterInterval& a, const ParameterInterval& b) {
  return a.from < b.to && b.from < a.to;
}

// Whether the leaves cover the rectangle, or its part where first <= second; where a leaf covers it
// in part, it is cut along that leaf's border.
bool covered(const ParameterInterval& first, const ParameterInterval& second, const Pairs& leaves,
             bool ordered) {
  if (ordered && first.from >= second.to) {
    return true;
  }
  Pairs near;
  for (const DiscPairs* leaf : leaves) {
    if (meet(leaf->first, first) && meet(leaf->second, second)) {
      near.push_back(leaf);
    }
  }
  if (near.empty()) {
    return false;
  }
  const DiscPairs& leaf = *near[near.size() / 2];
  for (const double cut : {leaf.first.from, leaf.first.to}) {
    if (first.from < cut && cut < first.to) {
      return covered({first.from, cut}, second, near, ordered) &&
             covered({cut, first.to}, second, near, ordered);
    }
  }
  for (const double cut : {leaf.second.from, leaf.second.to}) {
    if (second.from < cut && cut < second.to) {
      return covered(first, {second.from, cut}, near, ordered) &&
             covered(first, {cut, second.to}, near, ordered);
    }
  }
  return contains(leaf.first, first) && contains(leaf.second, second);
}

Pairs listed(const std::vector<DiscPairs>& leaves) {
  Pairs result;
  for (const DiscPairs& leaf : leaves) {
    result.push_back(&leaf);
  }
  return result;
}

using Sweep = std::function<Discs(const ParameterInterval&)>;

Sweep sweep_of(const CertifiedPart& part, const std::array<double, 2>& extension = {}) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    return [ball = Discs{{detail::interval_vec(sphere->center)}, {}, sphere->radius}](
               const ParameterInterval&) { return ball; };
  }
  return [tube = Tube(std::get<RingedSurface>(part.shape)), extension](const ParameterInterval& t) {
    if (t.to <= 0 && t.from < 0) {
      return tube.extended(t.from, t.to, extension[0]);
    }
    return t.from >= 1 && t.to > 1 ? tube.extended(t.from, t.to, extension[1])
                                   : tube.discs(t.from, t.to);
  };
}

// The width of the slab between them.
double apart(const Discs& first, const Discs& second, const Vec3& direction) {
  const IntervalVec w = detail::interval_vec(direction);
  const Interval behind = furthest(first, w), front = furthest(second, Interval(-1) * w);
  const Interval length = norm(w);
  return length.lower > 0 ? ((-front - behind) / length).lower : -1;
}

// The lemma of docs/certificate_format.md; the surface is known to be regular with this margin.
bool turns_little(const Tube& tube, const ParameterInterval& t, const EmbeddedClaim& claim,
                  double margin) {
  const double from = std::clamp(t.from, 0.0, 1.0), to = std::clamp(t.to, 0.0, 1.0);
  Interval range = tube.radius_range(from, to);
  bool grows = true, falls = true;
  if (from < to) {
    if (!(turning(tube.discs(from, to).tangents) <= std::numbers::pi / 2)) {
      return false;
    }
    Polynomial r = tube.radius(from, to);
    if (r.empty()) {
      r = {evaluate(tube.surface().radius, 0).value, evaluate(tube.surface().radius, 1).value};
    }
    grows = std::is_sorted(r.begin(), r.end());
    falls = std::is_sorted(r.rbegin(), r.rend());
  }
  if (t.from < 0) {
    range = hull(range, tube.extended(t.from, std::min(t.to, 0.0), claim.extension[0]).radius);
    grows = grows && tube.surface().start.slope <= 0;
    falls = falls && tube.surface().start.slope >= 0;
  }
  if (t.to > 1) {
    range = hull(range, tube.extended(std::max(t.from, 1.0), t.to, claim.extension[1]).radius);
    grows = grows && tube.surface().end.slope >= 0;
    falls = falls && tube.surface().end.slope <= 0;
  }
  return range.lower > 0 &&
         (grows || falls || ((Interval(1) - margin) * range.upper).upper <= range.lower);
}

// The plane of the discs passes the point within the stretch, which is nearer than the radius then.
bool crosses(const Discs& discs, const Vec3& point) {
  const IntervalVec p = detail::interval_vec(point);
  const bool passes =
      discs.tangents.empty() || (dot(p - discs.centers.front(), discs.tangents.front()).lower > 0 &&
                                 dot(p - discs.centers.back(), discs.tangents.back()).upper < 0);
  return passes && std::all_of(discs.centers.begin(), discs.centers.end(), [&](const auto& center) {
           return norm(p - center).upper < discs.radius.lower;
         });
}

bool follows(const Overlap& overlap, const Sweep& first, const Sweep& second) {
  const ParameterInterval all{0, 1};
  return contains(all, overlap.first) && contains(all, overlap.second) &&
         overlap.first.from < overlap.first.to && overlap.second.from < overlap.second.to &&
         crosses(first(overlap.first), overlap.point) &&
         crosses(second(overlap.second), overlap.point);
}

bool within_one_piece(const ParameterInterval& t) {
  return t.from < t.to && std::floor(t.from) + 1 >= t.to;
}

// The length of the straight part beyond an end.
double straight_neighbour(const std::vector<CertifiedPart>& parts,
                          const std::optional<EndIndex>& end) {
  const auto* tube = end ? std::get_if<RingedSurface>(&parts[end->part].shape) : nullptr;
  const auto* line = tube != nullptr ? std::get_if<LineSpine>(&tube->spine) : nullptr;
  const bool is_straight = line != nullptr && Tube(*tube).radius(0, 1).size() - 1 < 2 &&
                           !std::holds_alternative<BezierRadius>(tube->radius);
  return is_straight ? (line->to - line->from).norm() : 0;
}

bool follows(const std::vector<CertifiedPart>& parts, const CertifiedPart& part,
             const EmbeddedClaim& claim, const RegularClaim& regular) {
  const Sweep sweep = sweep_of(part, claim.extension);
  if (claim.verdict == Verdict::refuted) {
    return claim.overlap &&
           (claim.overlap->first.to < claim.overlap->second.from ||
            claim.overlap->second.to < claim.overlap->first.from) &&
           follows(*claim.overlap, sweep, sweep);
  }
  const ParameterInterval all{claim.extension[0] > 0 ? -1.0 : 0.0,
                              claim.extension[1] > 0 ? 2.0 : 1.0};
  for (const std::size_t end : {0, 1}) {
    if (claim.extension[end] != straight_neighbour(parts, part.joined[end])) {
      return false;
    }
  }
  if (regular.verdict != Verdict::proved || !covered(all, all, listed(claim.leaves), true)) {
    return false;
  }
  const Tube tube(std::get<RingedSurface>(part.shape));
  return std::all_of(claim.leaves.begin(), claim.leaves.end(), [&](const DiscPairs& leaf) {
    if (!within_one_piece(leaf.first) || !within_one_piece(leaf.second) ||
        !contains(all, leaf.first) || !contains(all, leaf.second)) {
      return false;
    }
    return leaf.direction
               ? apart(sweep(leaf.first), sweep(leaf.second), *leaf.direction) > 0
               : leaf.first.from <= leaf.second.from &&
                     turns_little(tube, {leaf.first.from, std::max(leaf.first.to, leaf.second.to)},
                                  claim, regular.margin);
  });
}

bool follows(const std::vector<CertifiedPart>& parts, const ClearanceClaim& claim) {
  for (const std::uint32_t part : {claim.first, claim.second}) {
    if (std::holds_alternative<OtherShape>(parts[part].shape)) {
      return false;
    }
  }
  const Sweep first = sweep_of(parts[claim.first]), second = sweep_of(parts[claim.second]);
  if (claim.overlap) {
    return follows(*claim.overlap, first, second);
  }
  const ParameterInterval all{0, 1};
  return claim.verdict == Verdict::proved && claim.distance > 0 &&
         covered(all, all, listed(claim.leaves), false) &&
         std::all_of(claim.leaves.begin(), claim.leaves.end(), [&](const DiscPairs& leaf) {
           return leaf.direction && contains(all, leaf.first) && contains(all, leaf.second) &&
                  apart(first(leaf.first), second(leaf.second), *leaf.direction) >= claim.distance;
         });
}

// ---- the whole

void require(bool follows, const std::string& part, const std::string& claim) {
  if (!follows) {
    throw Error(Errc::invalid_argument, "the claim '" + claim + "' does not follow", part,
                "certificate");
  }
}

void verify_part(const std::vector<CertifiedPart>& parts, const CertifiedPart& part,
                 const PartClaims& claims) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    require(sphere->radius > 0 && claims.mesh && mesh_follows(*sphere, *claims.mesh), part.name,
            "mesh");
    return;
  }
  if (std::holds_alternative<OtherShape>(part.shape)) {
    require(claims.regular && claims.regular->verdict == Verdict::undecided && claims.embedded &&
                claims.embedded->verdict == Verdict::undecided && claims.tangency.empty() &&
                !claims.mesh,
            part.name, "undecided");
    return;
  }
  require(claims.regular && claims.embedded && claims.tangency.size() == 2, part.name, "regular");
  const Tube tube(std::get<RingedSurface>(part.shape));
  require(claims.regular->verdict == Verdict::undecided || follows(tube, *claims.regular),
          part.name, "regular");
  require(claims.embedded->verdict == Verdict::undecided ||
              follows(parts, part, *claims.embedded, *claims.regular),
          part.name, "embedded");
  require(follows(tube, claims.tangency[0], false) && follows(tube, claims.tangency[1], true),
          part.name, "tangency");
  require(claims.mesh && mesh_follows(tube, *claims.mesh), part.name, "mesh");
}

bool joined(const CertifiedPart& part, std::uint32_t other) {
  return std::any_of(part.joined.begin(), part.joined.end(),
                     [other](const auto& end) { return end && end->part == other; });
}

}  // namespace
}  // namespace dupin::verifier

namespace dupin {

void verify(const Certificate& certificate) {
  const auto& parts = certificate.parts;
  verifier::require(certificate.claims.size() == parts.size(), "", "parts");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    verifier::verify_part(parts, parts[i], certificate.claims[i]);
  }
  auto claim = certificate.clearances.begin();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) {
      if (verifier::joined(parts[i], j)) {
        continue;
      }
      verifier::require(
          claim != certificate.clearances.end() && claim->first == i && claim->second == j &&
              (claim->verdict == Verdict::undecided || verifier::follows(parts, *claim)),
          parts[i].name, "clearance of " + parts[j].name);
      ++claim;
    }
  }
  verifier::require(claim == certificate.clearances.end(), "", "clearance");
}

}  // namespace dupin
