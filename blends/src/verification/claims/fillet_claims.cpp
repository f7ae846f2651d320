#include "verification/claims/fillet_claims.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>

#include "verification/admitted.h"
#include "verification/claims/mesh_claim.h"
#include "verification/covering.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

using numbers::cross;
using numbers::dot;
using numbers::norm;

constexpr double kLength = 2;  // of a loop, in t
constexpr double kInfinity = std::numeric_limits<double>::infinity();

ParameterInterval cell(const ParameterInterval& t, int i, int cells) {
  return {std::lerp(t.from, t.to, double(i) / cells),
          std::lerp(t.from, t.to, double(i + 1) / cells)};
}

// The cells that a stretch meets.
using Way = std::span<const ArcCell>;

Interval spins(const ContactArcs& arcs) { return hull(arcs.spin[0], arcs.spin[1]); }

}  // namespace

Way cells_of(const std::vector<ArcCell>& cells, const ParameterInterval& t) {
  const auto first =
      std::ranges::upper_bound(cells, t.from, {}, [](const ArcCell& c) { return c.t.to; });
  const auto last = std::ranges::lower_bound(first, cells.end(), t.to, {},
                                             [](const ArcCell& c) { return c.t.from; });
  spend(1 + std::uint64_t(last - first) / 4);
  return {first, last};
}

bool moves_along(Way way, const IntervalVec& d) {
  return std::ranges::all_of(way, [&](const ArcCell& cell) {
    const ContactArcs& arcs = cell.arcs;
    const Interval speed = arcs.passing * dot(arcs.tangent, d) - arcs.lag * dot(arcs.turning, d) +
                           arcs.growth * along_arcs(arcs, d) +
                           arcs.radius * spins(arcs) * along_arcs(arcs, cross(d, arcs.tangent));
    return speed.lower > 0;
  });
}

double furthest(Way way, const IntervalVec& d) {
  double most = -kInfinity;
  for (const ArcCell& cell : way) {
    most = std::max(most, furthest(cell.arcs, d));
  }
  return most;
}

namespace {

// All arcs of the ways, one after the other, are in front of the planes of those before them.
bool advances(const std::array<Way, 2>& ways) {
  Interval phi = 0;
  for (const Way& way : ways) {
    for (const ArcCell& cell : way) {
      phi = phi + Interval(cell.arcs.length) * numbers::norm(cell.arcs.turning).upper;
    }
  }
  phi = phi.upper;
  const Interval cosine = (Interval(1) - square(phi) / 2).lower;
  return phi.upper < 1 && std::ranges::all_of(ways, [&](const Way& way) {
           return std::ranges::all_of(way, [&](const ArcCell& cell) {
             const ContactArcs& arcs = cell.arcs;
             const Interval sideways = Interval(arcs.lag.magnitude()) * norm(arcs.turning).upper +
                                       arcs.growth.magnitude() +
                                       arcs.radius * spins(arcs).magnitude();
             return (Interval(arcs.passing.lower) * cosine - sideways.upper * phi).lower > 0;
           });
         });
}

bool is_short_way(const CanalFillet& loop, const std::vector<ArcCell>& cells,
                  const DiscPairs& leaf) {
  if (leaf.first.from > leaf.second.from) {
    return false;
  }
  const auto passes_one = [&](const ParameterInterval& t) {
    return t.from < 1 && t.to > 1 && has_corner(loop, 1);
  };
  const ParameterInterval all{leaf.first.from, std::max(leaf.first.to, leaf.second.to)};
  if (!passes_one(all) && advances({cells_of(cells, all), Way{}})) {
    return true;
  }
  const ParameterInterval on{leaf.second.from, kLength}, again{0, leaf.first.to};
  return !has_corner(loop, 0) && !passes_one(on) && !passes_one(again) &&
         advances({cells_of(cells, on), cells_of(cells, again)});
}

// On both sides of a corner, where both stretches end.
bool is_at_corner(const CanalFillet& loop, const DiscPairs& leaf) {
  return (leaf.first.to == 1 && leaf.second.from == 1 && has_corner(loop, 1)) ||
         (leaf.first.from == 0 && leaf.second.to == kLength && has_corner(loop, 0));
}

bool are_apart(Way first, Way second, const IntervalVec& d) {
  return (Interval(furthest(first, d)) + furthest(second, Interval(-1) * d)).upper < 0;
}

bool is_leaf(const ParameterInterval& t) {
  return is_stretch(t, kLength) && t.from < t.to && (t.to <= 1 || t.from >= 1);
}

constexpr std::size_t kOrders = 13;

// The quadric's distance from the balls' centres, less their radius.
Jet<kOrders> misfit(const Ring& quadric, const BallJets<kOrders>& balls) {
  return seen_from(quadric, balls.center).distance - balls.radius;
}

constexpr int kCells = 16, kHalvings = 40;

// Of all of a loop, in cells that are halved where it cannot be told of them.
template <class Check>
bool holds_halved(const Check& holds_on, const ParameterInterval& t, int halvings) {
  if (holds_on(t)) {
    return true;
  }
  const double middle = std::midpoint(t.from, t.to);
  return halvings > 0 && holds_halved(holds_on, {t.from, middle}, halvings - 1) &&
         holds_halved(holds_on, {middle, t.to}, halvings - 1);
}

template <class Check>
bool holds_all_along(const Check& holds_on) {
  for (int i = 0; i < kCells; ++i) {
    if (!holds_halved(holds_on, cell({0, kLength}, i, kCells), kHalvings)) {
      return false;
    }
  }
  return true;
}

// How far the point is beyond the ring, along its outward normal, from above.
double beyond(const Ring& ring, const JetVec<2>& point) {
  const IntervalVec normal = interval_vec(ring.normal);
  const IntervalVec to = part(point, 0) - interval_vec(ring.center);
  return (dot(to, normal) / norm(normal)).upper;
}

bool touches_between_on(const CanalFillet& loop, const std::array<Ring, 2>& starts,
                        double tolerance, const ParameterInterval& t) {
  constexpr std::uint64_t kWork = 16;
  spend(rolls_on_cones(loop) ? 2 * kWork : kWork);
  const JetVec<2> ball = balls_on<2>(loop, turn_stretch(t).value()).center;
  for (std::size_t side = 0; side < 2; ++side) {
    const Ring& quadric = loop.quadrics.at(side);
    const auto [normal, distance] = seen_from(quadric, ball);
    const JetVec<2> foot = ball - distance * normal;
    if (!(std::max(beyond(quadric, foot), beyond(starts.at(side), foot)) <= tolerance)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool touches_on(const CanalFillet& loop, const ContactClaim& claim, const ParameterInterval& t) {
  constexpr std::uint64_t kWork = 64;
  spend(rolls_on_cones(loop) ? kConeWork : kWork);
  const double middle = std::midpoint(t.from, t.to);
  // Sixteenths of a loop and their halves lie in one half of it.
  const TurnStretch all = turn_stretch(t).value(), at = turn_stretch({middle, middle}).value();
  const auto balls = balls_around<kOrders>(loop, at, all), ball = balls_on<kOrders>(loop, at);
  const Interval speed = sqrt(squared_norm(derivative(balls.center)))[0];
  const Interval sine = Interval(balls.radius[1].magnitude()) / speed;
  return std::all_of(loop.quadrics.begin(), loop.quadrics.end(), [&](const Ring& quadric) {
    const TaylorRange off = taylor_range(misfit(quadric, ball), misfit(quadric, balls), all.reach);
    // The sine of how far the foot is off the circle's plane differs by so much.
    const Interval lean = Interval(off.slope.magnitude()) / speed;
    // Where the ball may stand, or its circle has no radius, that is the line.
    const Interval deviation = lean / sqrt(Interval(1) - square(sine + lean));
    return off.value.magnitude() <= claim.offset && deviation.upper <= claim.deviation;
  });
}

namespace {

// With x = C + c w, b = T x w and the spin s of w: w' = -(w.T') T + s b.
Interval along(const ContactArcs& a) {
  const Interval spin = spins(a), turning = norm(a.turning), radius = a.radius.magnitude();
  const Interval forward =
      a.second_advance + a.lag * square(turning) - Interval(2) * a.growth * a.bending -
      a.radius * along_arcs(a, a.second_turning) -
      Interval(2) * a.radius * spin * along_arcs(a, cross(a.turning, a.tangent));
  const Interval to_arc = Interval(a.second_growth.magnitude()) + radius * square(spin);
  const Interval across = Interval((Interval(2) * a.growth * spin).magnitude()) +
                          radius * hull(a.spin_change[0], a.spin_change[1]).magnitude();
  const Interval aside = turning * (a.passing - a.second_lag).magnitude() +
                         Interval(a.lag.magnitude()) * norm(a.second_turning) +
                         sqrt(square(to_arc) + square(across));
  return sqrt(square(forward) + square(aside));
}

void bound_derivatives(ArcCell& cell) {
  const ContactArcs& arcs = cell.arcs;
  const Interval chord = norm(arcs.toward[0] - arcs.toward[1]).upper;
  const Interval rest = sqrt(max(Interval(4) - square(chord), 0));
  const Interval arc = narrowed(Mpfi(2) * angle(Mpfi(chord.upper), Mpfi(rest.lower))).upper;
  const Interval radius = arcs.radius.magnitude();
  const Interval across =
      arc * arcs.growth.magnitude() + radius * (arcs.spin[1] - arcs.spin[0]).magnitude();
  const Interval turning = square(norm(arcs.turning)) + square(spins(arcs));
  cell.along = along(arcs).upper;
  cell.mixed = sqrt(square(across) + square(radius * arc) * turning).upper;
  cell.around = (radius * square(arc)).upper;
  for (const IntervalVec& corner : arcs.corners) {
    cell.size = std::max(cell.size, norm(corner).upper);
  }
}

}  // namespace

bool has_form(const RegularClaim& claim) {
  return claim.margin >= 0 && claim.margin < 1 && claim.where == ParameterInterval{} &&
         (claim.verdict == Verdict::proved || claim.leaves.empty()) &&
         claim.verdict != Verdict::refuted;
}

std::optional<ArcCell> regular_cell(const CanalFillet& loop, const ParameterInterval& leaf,
                                    double margin) {
  auto arcs = is_leaf(leaf) ? contact_arcs(loop, leaf) : std::nullopt;
  if (!arcs || !(arcs->passing.lower > (Interval(margin) * arcs->speed).upper)) {
    return std::nullopt;
  }
  ArcCell cell{leaf, *arcs};
  bound_derivatives(cell);
  return cell;
}

std::optional<std::vector<ArcCell>> regular_cells(const CanalFillet& loop,
                                                  const RegularClaim& claim) {
  constexpr std::size_t kAtOnce = 1 << 10;  // cells are large, and the first may be wrong
  const auto& leaves = claim.leaves;
  std::vector<ArcCell> cells;
  while (cells.size() < leaves.size()) {
    const std::size_t begin = cells.size();
    std::vector<std::optional<ArcCell>> found(std::min(kAtOnce, leaves.size() - begin));
    const auto is_next = [&](std::size_t i) {
      const ParameterInterval& leaf = leaves[begin + i];
      found[i] = regular_cell(loop, leaf, claim.margin);
      return found[i] && leaf.from == (begin + i == 0 ? 0 : leaves[begin + i - 1].to);
    };
    if (!holds_of_all(found.size(), is_next)) {
      return std::nullopt;
    }
    std::ranges::transform(found, std::back_inserter(cells), [](auto& cell) { return *cell; });
  }
  const double reached = leaves.empty() ? 0 : leaves.back().to;
  const bool all = has_form(claim) && claim.verdict == Verdict::proved && reached == kLength;
  return all ? std::optional(std::move(cells)) : std::nullopt;
}

bool holds(const CanalFillet& loop, const std::vector<ArcCell>& cells, const DiscPairs& leaf) {
  if (!is_leaf(leaf.first) || !is_leaf(leaf.second)) {
    return false;
  }
  if (!leaf.direction) {
    return is_short_way(loop, cells, leaf);
  }
  const IntervalVec d = numbers::interval_vec(*leaf.direction);
  const Way first = cells_of(cells, leaf.first), second = cells_of(cells, leaf.second);
  return is_point(*leaf.direction) &&
         (are_apart(first, second, d) ||
          (is_at_corner(loop, leaf) && moves_along(first, d) && moves_along(second, d)));
}

bool follows(const CanalFillet& loop, const std::vector<ArcCell>& cells,
             const EmbeddedClaim& claim) {
  const ParameterInterval all{0, kLength};
  return claim.verdict == Verdict::proved && !claim.overlap &&
         covered(all, all, claim.leaves, true) &&
         holds_of_all(claim.leaves.size(),
                      [&](std::size_t i) { return holds(loop, cells, claim.leaves[i]); });
}

bool follows(const CanalFillet& loop, const ContactClaim& claim) {
  return is_bound(claim.offset) && is_bound(claim.deviation) &&
         holds_all_along([&](const ParameterInterval& t) { return touches_on(loop, claim, t); });
}

RolledPipes rolled_pipes(const std::array<Ring, 2>& quadrics,
                         const std::array<const Piece*, 2>& pipes) {
  RolledPipes result;
  for (std::size_t side = 0; side < 2; ++side) {
    const Piece& pipe = *pipes.at(side);
    const auto [offset, deviation] = difference_from(quadrics.at(side), pipe.tubes.front());
    result.starts.at(side) = pipe.start;
    result.difference.offset = std::max(result.difference.offset, offset);
    result.difference.deviation = std::max(result.difference.deviation, deviation);
  }
  return result;
}

ContactClaim about_quadrics(const ContactClaim& claim, const ConeDifference& difference) {
  return {(Interval(claim.offset) - difference.offset).lower,
          (Interval(claim.deviation) - difference.deviation).lower};
}

bool touches_between(const CanalFillet& loop, const std::array<Ring, 2>& starts, double tolerance) {
  return holds_all_along(
      [&](const ParameterInterval& t) { return touches_between_on(loop, starts, tolerance, t); });
}

double mesh_error(const std::vector<ArcCell>& cells, const MeshClaim& claim) {
  const auto& knots = claim.knots;
  if (knots.size() < 3 || knots.front() != 0 || knots.back() != kLength) {
    return kInfinity;
  }
  const Interval du = Interval(1) / double(claim.segments);
  Interval error = 0;
  double size = 0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const ParameterInterval band{knots[i], knots[i + 1]};
    const auto turn = is_leaf(band) ? turn_stretch(band) : std::nullopt;
    if (!turn) {
      return kInfinity;
    }
    Interval along = 0, mixed = 0, around = 0;
    for (const ArcCell& cell : cells_of(cells, band)) {
      along = max(along, cell.along);
      mixed = max(mixed, cell.mixed);
      around = max(around, cell.around);
      size = std::max(size, cell.size);
    }
    const Interval dt = turn->length;
    error = max(error, square(dt) * along + Interval(2) * dt * du * mixed + square(du) * around);
  }
  return (error / 8 + displacement(claim.grid, size)).upper;
}

bool follows(const std::vector<ArcCell>& cells, const MeshClaim& claim) {
  return is_bound(claim.grid) && is_bound(claim.error_bound) && claim.axes == 0 &&
         !is_of_chain(claim) && claim.segments >= 1 &&
         claim.segments <= CertificateLimits::kSegments &&
         mesh_error(cells, claim) <= claim.error_bound;
}

}  // namespace dupin::verification
