#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "claims.h"

namespace dupin::verifier {
namespace {

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

}  // namespace

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

}  // namespace dupin::verifier
