#include "certification/prove_loop_clearance.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
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

constexpr std::size_t kTries = 64;  // boxes, before what else may hold is looked for

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

// Leaves near corners that two surfaces have in common, and planes elsewhere.
class MeetingSearch {
 public:
  // Directions that may tell two stretches apart in a corner, and how far apart that corner is
  // then.
  struct Corners {
    std::function<std::vector<Vec3>(const DiscPairs&)> directions;
    std::function<double(const DiscPairs&)> gap;
  };

  MeetingSearch(const SweptDiscs& first, const SweptDiscs& second, Corners corners,
                const ClearanceGoals& goals)
      : first_(first), second_(second), corners_(std::move(corners)), goals_(goals) {}

  ClearanceClaim run() {
    ClearanceClaim claim;
    for (const ParameterInterval& a : first_.stretches()) {
      for (const ParameterInterval& b : second_.stretches()) {
        if (!settle({a, b, {}}, kDepth)) {
          return claim;
        }
      }
    }
    claim.verdict = Verdict::proved;
    claim.leaves = std::move(leaves_);
    claim.corner = corner_;
    return claim;
  }

 private:
  static constexpr int kDepth = 30;

  bool settle(DiscPairs pair, int depth) {
    if (looked_at_++ > goals_.boxes || depth == 0 || first_.is_out_of_work()) {
      return false;
    }
    for (const Vec3& direction : corners_.directions(pair)) {
      pair.direction = direction;
      const double gap = corners_.gap(pair);
      if (gap <= goals_.corner) {
        corner_ = std::max(corner_, gap);
        leaves_.push_back(pair);
        return true;
      }
    }
    const Separation apart = separation(first_.over(pair.first), second_.over(pair.second));
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

  const SweptDiscs &first_, &second_;
  Corners corners_;
  ClearanceGoals goals_;
  std::size_t looked_at_ = 0;
  double corner_ = 0;
  std::vector<DiscPairs> leaves_;
};

ClearanceClaim prove_meeting(const SweptLoop& first, const SweptLoop& second,
                             const ClearanceGoals& goals) {
  const auto directions = [&](const DiscPairs& pair) {
    const Vec3 d =
        way_from_corner(second.arcs, pair.second) - way_from_corner(first.arcs, pair.first);
    return d.norm() > 0 ? std::vector{d} : std::vector<Vec3>();
  };
  const auto gap = [&](const DiscPairs& pair) {
    return verification::gap_at_corner(first.arcs, second.arcs, pair);
  };
  return MeetingSearch(first.sweep, second.sweep, {directions, gap}, goals).run();
}

// A part meets corners with the disc that it ends in.
ClearanceClaim prove_meeting(const SweptPart& part, const SweptLoop& loop,
                             const ClearanceGoals& goals) {
  std::vector<Vec3> outward;
  for (const Ring& ring : part.sweep.end_rings()) {
    outward.push_back(ring.normal);
  }
  const auto directions = [&](const DiscPairs&) { return outward; };
  const auto gap = [&](const DiscPairs& pair) {
    return verification::gap_at_corner(part.solid, loop.arcs, pair);
  };
  return MeetingSearch(part.sweep, loop.sweep, {directions, gap}, goals).run();
}

bool has_corners(const LoopArcs& arcs) {
  return verification::has_corner(*arcs.loop, 0) || verification::has_corner(*arcs.loop, 1);
}

}  // namespace

SweptDiscs swept_arcs(const LoopArcs& arcs, SearchWork* work) {
  const auto hull = [&cells = arcs.cells](const ParameterInterval& t) { return hull_of(cells, t); };
  return {arcs.cells.empty() ? std::size_t{0} : std::size_t{2}, hull, work};
}

// At a point in common first: what overlaps never comes apart.
ClearanceClaim prove_clearance(const SweptPart& part, const SweptLoop& loop,
                               const ClearanceGoals& goals) {
  if (part.sweep.length() == 0 || loop.sweep.length() == 0) {
    return {};
  }
  ClearanceClaim claim = prove_clearance(part.sweep, loop.sweep, std::min(goals.boxes, kTries));
  if (claim.verdict != Verdict::proved) {
    claim.overlap = overlap(part.sweep, points_of(loop.arcs));
    claim.verdict = claim.overlap ? Verdict::proved : Verdict::undecided;
  }
  if (claim.verdict != Verdict::proved && has_corners(loop.arcs)) {
    claim = prove_meeting(part, loop, goals);
  }
  return claim.verdict == Verdict::proved || goals.boxes <= kTries
             ? claim
             : prove_clearance(part.sweep, loop.sweep, goals.boxes);
}

ClearanceClaim prove_clearance(const SweptLoop& first, const SweptLoop& second,
                               const ClearanceGoals& goals) {
  if (first.sweep.length() == 0 || second.sweep.length() == 0) {
    return {};
  }
  if (verification::share_corners(*first.arcs.loop, *second.arcs.loop)) {
    return prove_meeting(first, second, {goals.boxes, 0});
  }
  if (has_corners(first.arcs) && has_corners(second.arcs)) {
    const ClearanceClaim claim =
        prove_clearance(first.sweep, second.sweep, std::min(goals.boxes, kTries));
    ClearanceClaim meeting =
        claim.verdict == Verdict::proved ? claim : prove_meeting(first, second, goals);
    if (meeting.verdict == Verdict::proved) {
      return meeting;
    }
  }
  return prove_clearance(first.sweep, second.sweep, goals.boxes);
}

}  // namespace dupin::certification
