#include "verification/claims/pair_claims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "verification/admitted.h"
#include "verification/covering.h"
#include "verification/work.h"

namespace dupin::verification {

namespace {

double furthest_disc(const Solid& solid, const ParameterInterval& t, const IntervalVec& w,
                     int cells) {
  double result = -std::numeric_limits<double>::infinity();
  if (solid.is_run(t)) {
    constexpr std::uint64_t kBoxesOfUnit = 4;
    spend(1 + std::uint64_t(t.to - t.from) / kBoxesOfUnit);
    for (auto i = std::size_t(t.from); i < std::size_t(t.to); ++i) {
      result = std::max(result, numbers::dot(solid.boxes()[i], w).upper);
    }
    return result;
  }
  for (int i = 0; i < cells; ++i) {
    const auto discs = solid.discs({std::lerp(t.from, t.to, double(i) / cells),
                                    std::lerp(t.from, t.to, double(i + 1) / cells)});
    if (!discs) {
      return std::numeric_limits<double>::infinity();
    }
    result = std::max(result, furthest(*discs, w));
  }
  return result;
}

}  // namespace

double furthest(const Solid& solid, const ParameterInterval& t, const IntervalVec& w, int cells) {
  double result = furthest_disc(solid, t, w, cells);
  for (const Sphere& knee : knees_at(solid, t)) {
    result =
        std::max(result, furthest({{numbers::interval_vec(knee.center)}, {}, knee.radius, 0}, w));
  }
  return result;
}

namespace {

using Reach = double (*)(const Solid&, const ParameterInterval&, const IntervalVec&, int);

// Whether there is a slab of this width, and of any, between the discs, or what else is meant.
bool apart(const Solid& first, const Solid& second, const DiscPairs& leaf, double distance,
           Reach reach = furthest) {
  constexpr int kMostCells = 16;
  const IntervalVec w = numbers::interval_vec(*leaf.direction);
  const Interval length = numbers::norm(w);
  for (int cells = 1; cells <= kMostCells; cells *= 2) {
    const Interval behind = reach(first, leaf.first, w, cells);
    const Interval front = reach(second, leaf.second, Interval(-1) * w, cells);
    const double width = length.lower > 0 ? ((-front - behind) / length).lower : -1;
    if (width > 0 && width >= distance) {
      return true;
    }
  }
  return false;
}

// Of a stretch of an arc, which is one of an ellipse with the semi-axes a and b, a circle but for
// rounding: min(a, b)^2 - R max(a, b), from below, and |a^2 - b^2| and
// max(a, b)^2, from above.
struct ArcRoom {
  double least;
  Interval difference, largest;
};

std::optional<ArcRoom> room_on_arc(const Piece& piece, const ParameterInterval& t) {
  const ArcSpine* arc = piece.tubes.empty() ? nullptr : piece.tubes.front().arc();
  const auto discs = arc != nullptr ? discs_of(piece, t) : std::nullopt;
  if (!discs) {
    return std::nullopt;
  }
  const IntervalVec u = numbers::interval_vec(arc->start) - numbers::interval_vec(arc->center);
  const IntervalVec v = numbers::cross(numbers::interval_vec(arc->axis), u);
  const Interval a = numbers::dot(u, u), b = numbers::dot(v, v);
  const Interval reach = Interval(discs->radius.magnitude()) * sqrt(max(a, b));
  return ArcRoom{(min(a, b) - reach).lower, (a - b).magnitude(), max(a, b).upper};
}

// The fifth lemma of docs/certificate_format.md: of discs on one arc.
bool turns_less_than_once(const Piece& piece, const ParameterInterval& t) {
  const auto room = room_on_arc(piece, t);
  return room && room->least > 0 &&
         narrowed(Mpfi(piece.tubes.front().arc()->angle) - 2 * Mpfi::pi()).upper < 0;
}

// The same lemma: all discs are on one side of the plane of the stretch's first, and of its last,
// and that by so much of how far their centres are from its own, from below; not positive where the
// numbers do not tell.
double share_on_one_side(const Piece& piece, const ParameterInterval& t) {
  const auto* line =
      piece.tubes.empty() ? nullptr : std::get_if<LineSpine>(&piece.tubes.front().surface().spine);
  if (line != nullptr) {
    return line->from != line->to ? 1 : 0;
  }
  const auto room = room_on_arc(piece, t);
  if (!room || !(room->least > 0)) {
    return 0;
  }
  const Mpfi half = Mpfi(piece.tubes.front().arc()->angle) * (Mpfi(t.to) - t.from) / 2;
  return narrowed(half - Mpfi::pi() / 2).upper < 0
             ? ((narrowed(cosine(half)) * room->least - room->difference) / room->largest).lower
             : 0;
}

// The first lemma of docs/certificate_format.md; the piece is known to be regular with this margin.
bool turns_little(const std::vector<Tube>& tubes, const ParameterInterval& t, double margin) {
  if (tubes.empty() ||
      !(turning(tubes.front().discs(t.from, t.to).tangents) <= std::numbers::pi / 2)) {
    return false;
  }
  Interval range = tubes.front().radius_range(t.from, t.to);
  bool grows = true, falls = true;
  for (const Tube& tube : tubes) {
    const Interval here = tube.radius_range(t.from, t.to);
    range = max(range, here);
    Polynomial r = tube.radius(t.from, t.to);
    if (r.empty()) {
      r = {tube.radius_at(End::start), tube.radius_at(End::end)};
    }
    grows = grows && std::is_sorted(r.begin(), r.end());
    falls = falls && std::is_sorted(r.rbegin(), r.rend());
  }
  return range.lower > 0 &&
         (grows || falls || ((Interval(1) - margin) * range.upper).upper <= range.lower);
}

// A stretch of a piece on the way between two discs, and what is between it and the one before.
struct Cell {
  const Piece* piece;
  ParameterInterval t;
  Step before;
};

bool append(const Solid& solid, const ParameterInterval& t, const Step& before,
            std::vector<Cell>& way) {
  for (const ParameterInterval& stretch : cut(t)) {
    const Piece* piece = solid.piece(stretch);
    const auto index = std::size_t(stretch.from);
    if (piece == nullptr) {
      return false;  // a ball
    }
    way.push_back(
        {piece, within_piece(stretch), stretch.from == t.from ? before : solid.step_at(index)});
  }
  return true;
}

// On longer ways some piece turns too much; so they are not looked at.
constexpr double kLongestWay = 2;

// How far the centres at both ends are from each other, from below. A way whose stretches are asked
// has been looked at in more places than these.
Interval chord(const Cell& stretch) {
  const WorkLimit not_counted(std::numeric_limits<std::uint64_t>::max());
  const auto& [piece, t, before] = stretch;
  const auto first = piece->steered(t.from, t.from), last = piece->steered(t.to, t.to);
  return first && last ? numbers::norm(part(last->center, 0) - part(first->center, 0)).lower : 0;
}

// What discs of such a radius may be further on than they should, at the joints of the way.
Interval loss_at_joints(const std::vector<Cell>& way, const Interval& radius) {
  Interval loss = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    loss = loss + way[i].before.gap + radius * way[i].before.turn;
  }
  return loss.upper;
}

// What bounds the discs of a cell; the share is of how far centres move.
struct Bounds {
  Interval advance, sideways, turning, speed;
};

Interval least_share(std::span<const Bounds> cells, const Interval& phi, const Interval& radius) {
  const Interval cosine = (Interval(1) - square(phi) / 2).lower;
  double least = 1;
  for (const auto& [advance, sideways, turning, speed] : cells) {
    const Interval rest = advance * cosine - sideways * phi - radius * turning;
    least = std::min(least, rest.lower > 0 ? (rest / speed).lower : 0);
  }
  return least;
}

// The second lemma, with sines and cosines replaced by phi and 1 - phi^2 / 2.
bool advances(const std::vector<Cell>& way, int cells) {
  std::vector<Bounds> all;
  Interval radius = 0, phi = 0;
  for (const auto& [piece, t, before] : way) {
    phi = phi + before.turn;
    for (int i = 0; i < cells; ++i) {
      const double from = std::lerp(t.from, t.to, double(i) / cells);
      const double to = std::lerp(t.from, t.to, double(i + 1) / cells);
      const auto disc = piece->steered(from, to);
      if (!disc || !(disc->radius[0].lower > 0)) {
        return false;
      }
      const IntervalVec normal = part(disc->normal, 0), velocity = part(disc->center, 1);
      const Interval turning = numbers::norm(part(disc->normal, 1)).upper;
      all.push_back({numbers::dot(velocity, normal).lower,
                     numbers::norm(numbers::cross(velocity, normal)).upper, turning,
                     numbers::norm(velocity).upper});
      radius = std::max(radius.upper, disc->radius[0].upper);
      phi = phi + (Interval(to) - from) * turning;
    }
  }
  phi = phi.upper;
  const Interval loss = loss_at_joints(way, radius);
  for (std::size_t i = 0; phi.upper < 1 && i < way.size(); ++i) {
    const Interval share = least_share(
        std::span(all).subspan(i * std::size_t(cells), std::size_t(cells)), phi, radius);
    if (!(share.lower > 0 && (way.size() == 1 || (share * chord(way[i]) - loss).lower > 0))) {
      return false;
    }
  }
  return phi.upper < 1;
}

bool advances(const std::vector<Cell>& way) {
  constexpr int kMostCells = 32;
  for (int cells = 2; cells <= kMostCells; cells *= 4) {
    if (advances(way, cells)) {
      return true;
    }
  }
  return false;
}

// The fifth lemma, of the discs before and behind a joint.
bool stays_apart(const std::vector<Cell>& way) {
  if (way.size() != 2) {
    return false;
  }
  Interval radius = 0;
  std::array<double, 2> shares{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [piece, t, before] = way[i];
    shares.at(i) = share_on_one_side(*piece, t);
    if (!(shares.at(i) > 0)) {
      return false;
    }
    for (const Tube& tube : piece->tubes) {
      radius = std::max(radius.upper, tube.radius_range(t.from, t.to).magnitude());
    }
  }
  const Interval loss = loss_at_joints(way, radius), turn = way.back().before.turn;
  return std::ranges::all_of(std::array{0, 1}, [&](int i) {
    const Interval share = Interval(shares.at(std::size_t(i))) - turn;
    return share.lower > 0 && (share * chord(way[std::size_t(i)]) - loss).lower > 0;
  });
}

bool does_not_come_back(const std::vector<Cell>& way) { return stays_apart(way) || advances(way); }

// Exactly: the point lies in the plane of the ring, and not outside of it.
bool lies_in(const Ring& ring, const Vec3& point) {
  mpq_class height, squared;
  for (int k = 0; k < 3; ++k) {
    const mpq_class d = mpq_class(point[k]) - mpq_class(ring.center[k]);
    height += d * mpq_class(ring.normal[k]);
    squared += d * d;
  }
  return !ring.ellipse && height == 0 && squared <= mpq_class(ring.radius) * mpq_class(ring.radius);
}

}  // namespace

namespace {

// Whether the normals stay on one side of some plane. They never vanish then, nor turn round.
bool keep_their_sense(const Discs& discs) {
  IntervalVec sum{0, 0, 0};
  for (const IntervalVec& tangent : discs.tangents) {
    sum = sum + tangent;
  }
  return discs.spread < 1 &&
         std::all_of(discs.tangents.begin(), discs.tangents.end(), [&](const IntervalVec& tangent) {
           return numbers::dot(sum, tangent).lower > 0;
         });
}

}  // namespace

// Where discs keep their sense, and the point comes from before them to behind them, one passes it.
bool crosses(const Solid& solid, const ParameterInterval& t, const numbers::IntervalVec& box) {
  const auto discs = solid.discs(t), first = solid.discs({t.from, t.from}),
             last = solid.discs({t.to, t.to});
  if (!(t.from < t.to) || !discs || !first || !last) {
    return false;
  }
  const bool passes =
      solid.ball() != nullptr ||
      (keep_their_sense(*discs) &&
       numbers::dot(box - first->centers.front(), first->tangents.front()).lower > 0 &&
       numbers::dot(box - last->centers.back(), last->tangents.back()).upper < 0);
  return passes &&
         std::all_of(discs->centers.begin(), discs->centers.end(), [&](const IntervalVec& center) {
           return numbers::norm(box - center).upper < discs->radius.lower;
         });
}

namespace {

bool crosses(const Solid& solid, const ParameterInterval& t, const Vec3& point) {
  if (!solid.pieces().empty() && !solid.closed() && t.from == t.to &&
      (t.from == 0 || t.to == solid.length())) {
    return lies_in(t.from == 0 ? solid.pieces().front().start : solid.pieces().back().end, point);
  }
  return verification::crosses(solid, t, numbers::interval_vec(point));
}

bool follows(const Overlap& overlap, const Solid& first, const Solid& second) {
  return is_point(overlap.point) && is_stretch(overlap.first, first.length()) &&
         is_stretch(overlap.second, second.length()) && first.is_full() && second.is_full() &&
         crosses(first, overlap.first, overlap.point) &&
         crosses(second, overlap.second, overlap.point);
}

// Whether the way between the discs of the leaf is one on which they do not come back.
bool is_short_way(const Solid& solid, const DiscPairs& leaf, double margin) {
  const ParameterInterval all{leaf.first.from, std::max(leaf.first.to, leaf.second.to)};
  const Piece* piece = solid.piece(all);
  if (leaf.first.from > leaf.second.from || (solid.has_kneecaps() && piece == nullptr)) {
    return false;
  }
  const double beyond = solid.length() - leaf.second.from + leaf.first.to;
  if (piece != nullptr && (turns_less_than_once(*piece, within_piece(all)) ||
                           turns_little(piece->tubes, within_piece(all), margin))) {
    return true;
  }
  std::vector<Cell> way, around;
  return (all.to - all.from <= kLongestWay && append(solid, all, {}, way) &&
          does_not_come_back(way)) ||
         (solid.closed() && beyond <= kLongestWay &&
          append(solid, {leaf.second.from, solid.length()}, {}, around) &&
          append(solid, {0, leaf.first.to}, solid.step_at(0), around) &&
          does_not_come_back(around));
}

// The discs from the stretch to the end where the joint is.
ParameterInterval to_joint(const Solid& solid, const ParameterInterval& t, End end) {
  return end == End::end ? ParameterInterval{t.from, solid.length()} : ParameterInterval{0, t.to};
}

bool is_short_way(const Solid& first, const Solid& second, const std::vector<JoinedEnds>& joints,
                  const DiscPairs& leaf) {
  return std::any_of(joints.begin(), joints.end(), [&](const JoinedEnds& joint) {
    const auto one = to_joint(first, leaf.first, joint.first);
    const auto other = to_joint(second, leaf.second, joint.second);
    const auto step = [&] {
      auto [normal, center] = second.outward(joint.second);
      return step_between(first.outward(joint.first), {Interval(-1) * normal, center});
    };
    std::vector<Cell> way;
    return joint.have_rims_apart && knees_at(first, one).empty() &&
           knees_at(second, other).empty() &&
           one.to - one.from + other.to - other.from <= kLongestWay &&
           append(first, one, {}, way) && append(second, other, step(), way) &&
           does_not_come_back(way);
  });
}

}  // namespace

bool has_leaf(const Solid& solid, const ParameterInterval& t) {
  return t.from < t.to && is_stretch(t, solid.length()) &&
         (solid.ball() != nullptr || solid.piece(t) != nullptr || solid.is_run(t));
}

namespace {

bool has_leaf(const Solid& first, const Solid& second, const DiscPairs& leaf) {
  const bool have_runs = first.is_run(leaf.first) || second.is_run(leaf.second);
  return has_leaf(first, leaf.first) && has_leaf(second, leaf.second) &&
         (leaf.direction ? is_point(*leaf.direction) : !have_runs);
}

}  // namespace

bool has_form(const EmbeddedClaim& claim) {
  return (claim.verdict == Verdict::proved || claim.leaves.empty()) &&
         claim.overlap.has_value() == (claim.verdict == Verdict::refuted);
}

bool has_form(const ClearanceClaim& claim) {
  const bool is_separated = claim.verdict == Verdict::proved && !claim.overlap;
  return is_bound(claim.distance) && is_bound(claim.corner) &&
         (claim.corner == 0 || (is_separated && claim.distance == 0)) &&
         (is_separated || (claim.leaves.empty() && claim.distance == 0)) &&
         (claim.verdict != Verdict::undecided || !claim.overlap);
}

namespace {

// With those of pieces that meet in a kneecap, of which nothing is claimed.
std::vector<DiscPairs> with_neighbours(std::vector<DiscPairs> leaves, const Solid& solid) {
  for (double i = 0; i < double(solid.knees().size()); ++i) {
    leaves.push_back({{i, i + 1}, {i + 1, i + 2}, {}});
  }
  return leaves;
}

// Within a piece nothing is said of the kneecaps at its ends.
bool is_apart(const Solid& solid, const DiscPairs& leaf) {
  const bool is_in_piece = solid.piece(leaf.first) == solid.piece(leaf.second);
  const Reach with_knees = furthest;
  return apart(solid, solid, leaf, 0, is_in_piece ? furthest_disc : with_knees);
}

}  // namespace

bool follows(const Solid& solid, const EmbeddedClaim& claim, const RegularClaim& regular) {
  if (!has_form(claim) || claim.verdict == Verdict::undecided) {
    return false;
  }
  if (claim.verdict == Verdict::refuted) {
    return claim.overlap->first.from < claim.overlap->first.to &&
           claim.overlap->second.from < claim.overlap->second.to &&
           (claim.overlap->first.to < claim.overlap->second.from ||
            claim.overlap->second.to < claim.overlap->first.from) &&
           follows(*claim.overlap, solid, solid);
  }
  const ParameterInterval all{0, solid.length()};
  return regular.verdict == Verdict::proved &&
         covered(all, all, with_neighbours(claim.leaves, solid), true) &&
         holds_of_all(claim.leaves.size(), [&](std::size_t i) {
           const DiscPairs& leaf = claim.leaves[i];
           return has_leaf(solid, solid, leaf) &&
                  (leaf.direction ? is_apart(solid, leaf)
                                  : is_short_way(solid, leaf, regular.margin));
         });
}

bool follows(const Solid& first, const Solid& second, const std::vector<JoinedEnds>& joints,
             const ClearanceClaim& claim) {
  const bool joined = !joints.empty();
  // No leaves at all cover the discs of a part of which nothing is known.
  if (!has_form(claim) || claim.verdict == Verdict::undecided || claim.corner != 0 ||
      std::min(first.length(), second.length()) == 0) {
    return false;
  }
  if (claim.overlap) {
    const bool touching = claim.overlap->first.from == claim.overlap->first.to ||
                          claim.overlap->second.from == claim.overlap->second.to;
    return !(joined && touching) &&
           claim.verdict == (joined ? Verdict::refuted : Verdict::proved) &&
           follows(*claim.overlap, first, second);
  }
  return claim.verdict == Verdict::proved && (joined ? claim.distance == 0 : claim.distance > 0) &&
         covered({0, first.length()}, {0, second.length()}, claim.leaves, false) &&
         holds_of_all(claim.leaves.size(), [&](std::size_t i) {
           const DiscPairs& leaf = claim.leaves[i];
           return has_leaf(first, second, leaf) &&
                  (leaf.direction ? apart(first, second, leaf, claim.distance)
                                  : is_short_way(first, second, joints, leaf));
         });
}

}  // namespace dupin::verification
