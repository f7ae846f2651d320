#include "verification/claims/loop_clearance.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <variant>
#include <vector>

#include "verification/admitted.h"
#include "verification/claims/pair_claims.h"
#include "verification/covering.h"

namespace dupin::verification {
namespace {

constexpr double kLength = 2;  // of a loop
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_leaf(const ParameterInterval& t) { return is_stretch(t, kLength) && t.from < t.to; }

// Whether there is a slab of this width, and of any, between what reaches as far as this.
bool are_apart(const Interval& behind, const Interval& front, const IntervalVec& d,
               double distance) {
  const Interval length = numbers::norm(d);
  const double width = length.lower > 0 ? ((-front - behind) / length).lower : -1;
  return width > 0 && width >= distance;
}

bool is_separated(const ClearanceClaim& claim, bool meet) {
  return has_form(claim) && claim.verdict == Verdict::proved && !claim.overlap &&
         (meet ? claim.distance == 0 : claim.distance > 0);
}

// The corner in which a stretch ends, and whether it comes before it.
struct AtCorner {
  double corner = 0;  // 0 or 1
  bool is_before = false;
};

std::optional<AtCorner> corner_of(const CanalFillet& loop, const ParameterInterval& t) {
  for (const double corner : {0.0, 1.0}) {
    const double end = corner == 0 ? kLength : 1;
    if (has_corner(loop, corner) && (t.from == corner || t.to == end)) {
      return AtCorner{corner, t.to == end};
    }
  }
  return std::nullopt;
}

// Which hold the arcs, on that side of a corner, in which they become a point but for rounding.
std::vector<IntervalVec> corner_points(const CanalFillet& loop, const AtCorner& at) {
  constexpr double kNext = 0x1p-52;
  const double end = at.corner == 0 && at.is_before ? kLength : at.corner;
  const auto arcs = contact_arcs(loop, at.is_before ? ParameterInterval{end - kNext, end}
                                                    : ParameterInterval{end, end + kNext});
  return arcs ? std::vector<IntervalVec>(arcs->corners.begin(), arcs->corners.end())
              : std::vector<IntervalVec>();
}

// Whether all arcs of a stretch move along d on their way from the corner.
bool moves_from(const LoopArcs& loop, const ParameterInterval& t, const AtCorner& at,
                const Vec3& d) {
  return moves_along(cells_of(loop.cells, t), numbers::interval_vec(at.is_before ? Vec3(-d) : d));
}

}  // namespace

bool share_corners(const CanalFillet& first, const CanalFillet& second) {
  const auto* a = std::get_if<RollingThrough>(&first.motion);
  const auto* b = std::get_if<RollingThrough>(&second.motion);
  return a != nullptr && b != nullptr && (has_corner(first, 0) || has_corner(first, 1)) &&
         a->origin == b->origin && a->along == b->along && a->across == b->across &&
         a->up == b->up && a->cosine == b->cosine && a->sine == b->sine &&
         a->distance == b->distance && a->height == b->height && a->below == b->below &&
         a->above == b->above && a->radius == b->radius;
}

double gap_at_corner(const LoopArcs& first, const LoopArcs& second, const DiscPairs& leaf) {
  const auto one = corner_of(*first.loop, leaf.first), other = corner_of(*second.loop, leaf.second);
  if (!leaf.direction || !one || !other ||
      !moves_from(first, leaf.first, *one, Vec3(-*leaf.direction)) ||
      !moves_from(second, leaf.second, *other, *leaf.direction)) {
    return kInfinity;
  }
  if (share_corners(*first.loop, *second.loop)) {
    return one->corner == other->corner ? 0 : kInfinity;
  }
  const auto from = corner_points(*first.loop, *one), to = corner_points(*second.loop, *other);
  double gap = from.empty() || to.empty() ? kInfinity : 0;
  for (const IntervalVec& a : from) {
    for (const IntervalVec& b : to) {
      gap = std::max(gap, numbers::norm(b - a).upper);
    }
  }
  return gap;
}

double gap_at_corner(const Solid& part, const LoopArcs& loop, const DiscPairs& leaf) {
  const auto corner = corner_of(*loop.loop, leaf.second);
  if (!leaf.direction || !corner || !moves_from(loop, leaf.second, *corner, *leaf.direction)) {
    return kInfinity;
  }
  const IntervalVec d = numbers::interval_vec(*leaf.direction);
  const Interval length = numbers::norm(d), reach = furthest(part, leaf.first, d, 1);
  const auto points = corner_points(*loop.loop, *corner);
  double gap = points.empty() || !(length.lower > 0) ? kInfinity : 0;
  for (const IntervalVec& point : points) {
    gap = std::max(gap, ((reach - numbers::dot(point, d)) / length).upper);
  }
  return gap;
}

bool follows(const Overlap& overlap, const Solid& part, const CanalFillet& loop) {
  const double t = overlap.second.from;
  if (!is_point(overlap.point) || !part.is_full() || !is_stretch(overlap.first, part.length()) ||
      !is_parameter(t, kLength) || overlap.second.to != t) {
    return false;
  }
  const auto arcs = contact_arcs(loop, {t, t});
  const IntervalVec point = numbers::interval_vec(overlap.point);
  const auto is_inside = [&](const IntervalVec& place) {
    const IntervalVec box{hull(point[0], place[0]), hull(point[1], place[1]),
                          hull(point[2], place[2])};
    return crosses(part, overlap.first, box);
  };
  return arcs &&
         (is_inside(arcs->corners[0]) || is_inside(arcs->corners[1]) || is_inside(arcs->middle));
}

bool follows(const Solid& part, const LoopArcs& loop, const ClearanceClaim& claim) {
  if (claim.overlap) {
    return has_form(claim) && claim.verdict == Verdict::proved &&
           follows(*claim.overlap, part, *loop.loop);
  }
  constexpr int kCells = 4;
  // No leaves at all cover the discs of a part of which nothing is known.
  return is_separated(claim, claim.corner > 0) && !loop.cells.empty() && part.length() > 0 &&
         covered({0, part.length()}, {0, kLength}, claim.leaves, false) &&
         std::ranges::all_of(claim.leaves, [&](const DiscPairs& leaf) {
           if (!has_leaf(part, leaf.first) || !is_leaf(leaf.second) || !leaf.direction ||
               !is_point(*leaf.direction)) {
             return false;
           }
           const IntervalVec d = numbers::interval_vec(*leaf.direction);
           const double front = furthest(cells_of(loop.cells, leaf.second), Interval(-1) * d);
           return are_apart(furthest(part, leaf.first, d, 1), front, d, claim.distance) ||
                  are_apart(furthest(part, leaf.first, d, kCells), front, d, claim.distance) ||
                  (claim.corner > 0 && gap_at_corner(part, loop, leaf) <= claim.corner);
         });
}

bool follows(const LoopArcs& first, const LoopArcs& second, const ClearanceClaim& claim) {
  const bool share = share_corners(*first.loop, *second.loop);
  const bool meet = share || claim.corner > 0;
  return is_separated(claim, meet) && !(share && claim.corner > 0) && !first.cells.empty() &&
         !second.cells.empty() && covered({0, kLength}, {0, kLength}, claim.leaves, false) &&
         std::ranges::all_of(claim.leaves, [&](const DiscPairs& leaf) {
           if (!is_leaf(leaf.first) || !is_leaf(leaf.second) || !leaf.direction ||
               !is_point(*leaf.direction)) {
             return false;
           }
           const IntervalVec d = numbers::interval_vec(*leaf.direction);
           return are_apart(furthest(cells_of(first.cells, leaf.first), d),
                            furthest(cells_of(second.cells, leaf.second), Interval(-1) * d), d,
                            claim.distance) ||
                  (meet && gap_at_corner(first, second, leaf) <= claim.corner);
         });
}

}  // namespace dupin::verification
