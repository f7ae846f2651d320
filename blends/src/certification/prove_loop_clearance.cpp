#include "certification/prove_loop_clearance.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "certification/swept_disc_overlap.h"
#include "certification/swept_disc_pairs.h"

namespace dupin::certification {
namespace {

using verification::ArcCell;
using verification::LoopArcs;

DiscHull hull_of(const std::vector<ArcCell>& cells, const ParameterInterval& t) {
  DiscHull result;
  result.radius = 0;
  for (auto cell =
           std::ranges::lower_bound(cells, t.from, {}, [](const ArcCell& c) { return c.t.to; });
       cell != cells.end() && cell->t.from <= t.to; ++cell) {
    if (t.from < t.to && (cell->t.to == t.from || cell->t.from == t.to)) {
      continue;
    }
    for (const auto& corner : cell->arcs.corners) {
      result.centers.push_back(corner);
    }
    // What has no normals is not divided.
    result.tangents.push_back(cell->arcs.tangent);
  }
  return result;
}

// Feet and middles of arcs along the loop.
std::vector<PlacedPoint> points_of(const LoopArcs& arcs) {
  constexpr int kArcs = 64;
  std::vector<PlacedPoint> points;
  for (int i = 0; i < kArcs; ++i) {
    const double t = 2 * (i + 0.5) / kArcs;
    if (const auto at = verification::contact_arcs(*arcs.loop, {t, t})) {
      for (const auto& place : {at->middle, at->corners[0], at->corners[1]}) {
        points.push_back({middle(place), t});
      }
    }
  }
  return points;
}

// Of the points of a stretch that ends in a corner, on their way from there.
Vec3 way_from_corner(const LoopArcs& arcs, const ParameterInterval& t) {
  const bool is_before = t.to == 1 || t.to == 2;
  const auto cell = std::ranges::find_if(arcs.cells, [&](const ArcCell& c) {
    return is_before ? c.t.to == t.to : c.t.from == t.from;
  });
  if (cell == arcs.cells.end()) {
    return Vec3::Zero();
  }
  const auto& a = cell->arcs;
  const Vec3 tangent = middle(a.tangent), toward = middle(a.toward[0]);
  const Vec3 motion =
      middle(a.passing) * tangent + middle(a.radius) * middle(a.spin[0]) * tangent.cross(toward);
  return (is_before ? -1 : 1) * motion.normalized();
}

// Leaves near the corners that two loops share, and planes elsewhere.
class MeetingSearch {
 public:
  MeetingSearch(const LoopArcs& first, const SweptDiscs& first_sweep, const LoopArcs& second,
                const SweptDiscs& second_sweep, std::size_t boxes)
      : first_(first),
        second_(second),
        first_sweep_(first_sweep),
        second_sweep_(second_sweep),
        boxes_(boxes) {}

  ClearanceClaim run() {
    ClearanceClaim claim;
    for (const ParameterInterval& a : first_sweep_.stretches()) {
      for (const ParameterInterval& b : second_sweep_.stretches()) {
        if (!settle({a, b, {}}, kDepth)) {
          return claim;
        }
      }
    }
    claim.verdict = Verdict::proved;
    claim.leaves = std::move(leaves_);
    return claim;
  }

 private:
  static constexpr int kDepth = 30;

  bool settle(DiscPairs pair, int depth) {
    if (looked_at_++ > boxes_ || depth == 0 || first_sweep_.is_out_of_work()) {
      return false;
    }
    pair.direction = way_from_corner(second_, pair.second) - way_from_corner(first_, pair.first);
    if (pair.direction->norm() > 0 && verification::part_at_corner(first_, second_, pair)) {
      leaves_.push_back(pair);
      return true;
    }
    const Separation apart =
        separation(first_sweep_.over(pair.first), second_sweep_.over(pair.second));
    if (apart.distance > 0) {
      pair.direction = apart.direction;
      leaves_.push_back(pair);
      return true;
    }
    const auto [a, b] = halves(pair.first);
    const auto [c, d] = halves(pair.second);
    return settle({a, c, {}}, depth - 1) && settle({a, d, {}}, depth - 1) &&
           settle({b, c, {}}, depth - 1) && settle({b, d, {}}, depth - 1);
  }

  const LoopArcs &first_, &second_;
  const SweptDiscs &first_sweep_, &second_sweep_;
  std::size_t boxes_, looked_at_ = 0;
  std::vector<DiscPairs> leaves_;
};

}  // namespace

SweptDiscs swept_arcs(const LoopArcs& arcs, SearchWork* work) {
  const auto hull = [&cells = arcs.cells](const ParameterInterval& t) { return hull_of(cells, t); };
  return {arcs.cells.empty() ? std::size_t{0} : std::size_t{2}, hull, work};
}

// At a point in common first: what overlaps never comes apart.
ClearanceClaim prove_clearance(const SweptDiscs& part, const LoopArcs& arcs, const SweptDiscs& loop,
                               std::size_t boxes) {
  constexpr std::size_t kTries = 64;
  if (part.length() == 0 || loop.length() == 0) {
    return {};
  }
  ClearanceClaim claim = prove_clearance(part, loop, std::min(boxes, kTries));
  if (claim.verdict != Verdict::proved) {
    claim.overlap = overlap(part, points_of(arcs));
    claim.verdict = claim.overlap ? Verdict::proved : Verdict::undecided;
  }
  return claim.verdict == Verdict::proved || boxes <= kTries ? claim
                                                             : prove_clearance(part, loop, boxes);
}

ClearanceClaim prove_clearance(const LoopArcs& first, const SweptDiscs& first_sweep,
                               const LoopArcs& second, const SweptDiscs& second_sweep,
                               std::size_t boxes) {
  if (first_sweep.length() == 0 || second_sweep.length() == 0) {
    return {};
  }
  return verification::share_corners(*first.loop, *second.loop)
             ? MeetingSearch(first, first_sweep, second, second_sweep, boxes).run()
             : prove_clearance(first_sweep, second_sweep, boxes);
}

}  // namespace dupin::certification
