#include "certification/swept_disc_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "certification/swept_disc_overlap.h"

namespace dupin::certification {
namespace {

// Shorter stretches only show the rounding of their ends; and one that gets shorter while the other
// stays long would be empty in the end.
constexpr double kShortest = 0x1p-40, kShortestOfOne = 0x1p-52;

bool are_too_short(const ParameterInterval& first, const ParameterInterval& second) {
  return std::max(size(first), size(second)) < kShortest ||
         std::min(size(first), size(second)) < kShortestOfOne;
}

// A stretch of one sweep against one of the same or another.
struct Box {
  ParameterInterval first, second;
  DiscHull first_hull, second_hull;
  Separation apart;
};

Box box(const SweptDiscs& a, const SweptDiscs& b, const ParameterInterval& s,
        const ParameterInterval& t) {
  Box result{s, t, a.over(s), b.over(t), {}};
  result.apart = separation(result.first_hull, result.second_hull);
  return result;
}

// Whether it is the first stretch that would be halved: a ball has none.
bool splits_first(const Box& whole) {
  const bool has_b = !whole.second_hull.tangents.empty();
  const bool has_a = !whole.first_hull.tangents.empty();
  return has_a && (!has_b || whole.first_hull.extent() >= whole.second_hull.extent());
}

std::vector<Box> split(const SweptDiscs& a, const SweptDiscs& b, const Box& whole) {
  if (splits_first(whole)) {
    const auto [left, right] = halves(whole.first);
    return {box(a, b, left, whole.second), box(a, b, right, whole.second)};
  }
  const auto [left, right] = halves(whole.second);
  return {box(a, b, whole.first, left), box(a, b, whole.first, right)};
}

// That of two discs of the box which are likely to be near each other.
double distance_that_occurs(const SweptDiscs& a, const SweptDiscs& b, const Box& box) {
  const auto nearer_end = [](const ParameterInterval& t, const DiscHull& hull, const Vec3& place) {
    const auto distance = [&](const numbers::IntervalVec& center) {
      return numbers::norm(center - numbers::interval_vec(place)).lower;
    };
    return distance(hull.centers.front()) <= distance(hull.centers.back()) ? t.from : t.to;
  };
  const double s = nearer_end(box.first, box.first_hull, box.second_hull.middle());
  const double t = nearer_end(box.second, box.second_hull, box.first_hull.middle());
  return separation(a.over({s, s}), b.over({t, t})).nearest;
}

}  // namespace

// Frank and Wolfe's descent towards the shortest vector from one hull to the other, in plain
// arithmetic; only the bound in the direction found is proven.
Separation separation(const DiscHull& first, const DiscHull& second) {
  constexpr int kDescents = 256;
  constexpr double kEnough = 0.99;  // of the distance of the hulls
  Vec3 gap = second.middle() - first.middle();
  Separation best;
  double width = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDescents && gap.norm() > 0; ++i) {
    const Vec3 direction = gap.normalized();
    const Vec3 nearer = support_point(second, -direction) - support_point(first, direction);
    if (nearer.dot(direction) > width) {
      width = nearer.dot(direction);
      best.direction = direction;
    }
    const Vec3 step = nearer - gap;
    const double along = std::min(-gap.dot(step) / step.squaredNorm(), 1.0);
    if (width > kEnough * gap.norm() || !(along > 0)) {
      break;
    }
    gap += along * step;
  }
  best.nearest = gap.norm();
  // What the rounding of the operands may hide from a checker.
  const double scale = first.middle().norm() + second.middle().norm() + first.extent() +
                       second.extent() + first.radius.upper + second.radius.upper;
  const numbers::Interval behind = support(first, best.direction),
                          front = support(second, -best.direction);
  best.distance = ((numbers::Interval(0) - front - behind) /
                       numbers::norm(numbers::interval_vec(best.direction)) -
                   kDiscSlack * scale)
                      .lower;
  return best;
}

namespace {

struct Pair {
  ParameterInterval first, second;
};

// Neighbours along a part of many pieces need so many for each.
std::size_t boxes_of_runs(const SweptDiscs& sweep) {
  constexpr std::size_t kBoxesOfPiece = 32;
  return sweep.has_runs() ? kBoxesOfPiece * std::size_t(sweep.length()) : 0;
}

using ShortWay = std::function<bool(const Pair&)>;

// Leaves that cover the pairs, each by a short way or a plane between; none when the limit of work
// was reached. Pairs of equal stretches are taken to need the order first <= second only.
std::optional<std::vector<DiscPairs>> leaves_of(const SweptDiscs& first, const SweptDiscs& second,
                                                std::vector<Pair> stack, const ShortWay& is_short,
                                                std::size_t boxes) {
  std::vector<DiscPairs> leaves;
  boxes += boxes_of_runs(first) + boxes_of_runs(second);
  for (std::size_t looked_at = 0; !stack.empty(); ++looked_at) {
    const Pair pair = stack.back();
    stack.pop_back();
    if (std::max(size(pair.first), size(pair.second)) <= 1 && is_short(pair)) {
      leaves.push_back({pair.first, pair.second, {}});
      continue;
    }
    if (looked_at >= boxes || first.is_out_of_work() || are_too_short(pair.first, pair.second)) {
      return std::nullopt;
    }
    const auto [left, right] = halves(pair.first);
    if (&first == &second && pair.first == pair.second) {
      stack.push_back({right, right});
      stack.push_back({left, right});
      stack.push_back({left, left});
      continue;
    }
    const Box whole = box(first, second, pair.first, pair.second);
    if (whole.apart.distance > 0) {
      leaves.push_back({pair.first, pair.second, whole.apart.direction});
    } else if (whole.first_hull.extent() >= whole.second_hull.extent()) {
      stack.push_back({right, pair.second});
      stack.push_back({left, pair.second});
    } else {
      const auto [near, far] = halves(pair.second);
      stack.push_back({pair.first, far});
      stack.push_back({pair.first, near});
    }
  }
  return leaves;
}

// Of a chain with kneecaps: its pieces, and what is not next to each other.
EmbeddedClaim prove_pieces_embedded(const SweptDiscs& sweep, std::size_t boxes,
                                    double longest_way) {
  const SweptDiscs discs = sweep.discs_only();
  const auto is_short = [&](const Pair& pair) {
    const ParameterInterval all{pair.first.from, pair.second.to};
    std::vector<DiscPace> way;
    return size(all) <= longest_way && discs.append_way(all, way) && advances(way);
  };
  const auto pieces = sweep.stretches();
  std::vector<Pair> own, others;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    own.push_back({pieces[i], pieces[i]});
    for (std::size_t j = i + 2; j < pieces.size(); ++j) {
      others.push_back({pieces[i], pieces[j]});
    }
  }
  auto leaves = leaves_of(discs, discs, std::move(own), is_short, boxes);
  const auto more = leaves_of(
      sweep, sweep, std::move(others), [](const Pair&) { return false; }, boxes);
  EmbeddedClaim claim;
  if (leaves && more) {
    leaves->insert(leaves->end(), more->begin(), more->end());
    claim.verdict = Verdict::proved;
    claim.leaves = std::move(*leaves);
  }
  return claim;
}

// Stretches before and behind a joint whose discs are on different sides of that of the joint.
bool stay_apart(const SweptDiscs& first, const ParameterInterval& t, const SweptDiscs& second,
                const ParameterInterval& s) {
  return size(t) <= 1 && size(s) <= 1 && first.stays_on_one_side(t) && second.stays_on_one_side(s);
}

// Whether discs do not come back on the way from the one to the other within a part.
bool is_short_way(const SweptDiscs& sweep, const Pair& pair, double longest_way) {
  const ParameterInterval all{pair.first.from, pair.second.to};
  const double joint = std::floor(pair.first.from) + 1;
  std::vector<DiscPace> way;
  return (joint < all.to && stay_apart(sweep, {all.from, joint}, sweep, {joint, all.to})) ||
         (size(all) <= longest_way && sweep.append_way(all, way) && advances(way));
}

// The same, by a way of two stretches that meet in a joint.
bool is_short_way(const SweptDiscs& first, const ParameterInterval& t, const SweptDiscs& second,
                  const ParameterInterval& s, double longest_way) {
  std::vector<DiscPace> way;
  return stay_apart(first, t, second, s) ||
         (size(t) + size(s) <= longest_way && first.append_way(t, way) &&
          second.append_way(s, way) && advances(way));
}

}  // namespace

EmbeddedClaim prove_embedded(const SweptDiscs& sweep, double margin, std::size_t boxes,
                             double longest_way) {
  if (sweep.has_kneecaps()) {
    return prove_pieces_embedded(sweep, boxes, longest_way);
  }
  EmbeddedClaim claim;
  std::vector<Pair> stack;
  const auto pieces = sweep.roots();
  for (std::size_t i = pieces.size(); i-- > 0;) {
    for (std::size_t j = pieces.size(); j-- > i;) {
      stack.push_back({pieces[i], pieces[j]});
    }
  }
  const auto is_short = [&](const Pair& pair) {
    return sweep.turns_little({pair.first.from, pair.second.to}, margin) ||
           is_short_way(sweep, pair, longest_way) ||
           (sweep.closed() && is_short_way(sweep, {pair.second.from, sweep.length()}, sweep,
                                           {0, pair.first.to}, longest_way));
  };
  auto leaves = leaves_of(sweep, sweep, std::move(stack), is_short, boxes);
  if (leaves) {
    claim.verdict = Verdict::proved;
    claim.leaves = std::move(*leaves);
    return claim;
  }
  claim.overlap = self_overlap(sweep);
  claim.verdict = claim.overlap ? Verdict::refuted : Verdict::undecided;
  return claim;
}

ClearanceClaim prove_joint(const SweptDiscs& first, const SweptDiscs& second,
                           const std::vector<JoinedEnds>& joints, std::size_t boxes) {
  ClearanceClaim claim;
  std::vector<Pair> stack;
  for (const auto& a : first.roots()) {
    for (const auto& b : second.roots()) {
      stack.push_back({a, b});
    }
  }
  const auto to_joint = [](const SweptDiscs& sweep, const ParameterInterval& t, End end) {
    return end == End::end ? ParameterInterval{t.from, sweep.length()} : ParameterInterval{0, t.to};
  };
  const auto is_short = [&](const Pair& pair) {
    return std::any_of(joints.begin(), joints.end(), [&](const JoinedEnds& joint) {
      const auto one = to_joint(first, pair.first, joint.first);
      const auto other = to_joint(second, pair.second, joint.second);
      return !first.touches_knee(one) && !second.touches_knee(other) &&
             is_short_way(first, one, second, other, kLongestWay);
    });
  };
  auto leaves = leaves_of(first, second, std::move(stack), is_short, boxes);
  if (leaves) {
    claim.verdict = Verdict::proved;
    claim.leaves = std::move(*leaves);
    return claim;
  }
  claim.overlap = overlap_between_axes(first, second);
  if (!claim.overlap) {
    claim.overlap = overlap(first, second);
  }
  claim.verdict = claim.overlap ? Verdict::refuted : Verdict::undecided;
  return claim;
}

namespace {

// So many are looked at before a common point is looked for: more of long parts, where that takes
// more, and which come apart later.
std::size_t boxes_before_points(const SweptDiscs& first, const SweptDiscs& second) {
  constexpr std::size_t kTries = 64, kTriesOfPiece = 4;
  const bool have_runs = first.has_runs() || second.has_runs();
  return kTries + (have_runs ? kTriesOfPiece * std::size_t(first.length() + second.length()) : 0);
}

}  // namespace

// Best first: the box with the smallest bound is divided until the bound is close to a distance
// that certainly occurs, that of two points.
ClearanceClaim prove_clearance(const SweptDiscs& first, const SweptDiscs& second, std::size_t boxes,
                               std::size_t tight) {
  const auto enough = [=](std::size_t looked_at) {  // of the distance
    return looked_at <= tight ? 0.9 : looked_at <= 2 * tight ? 0.6 : 0.3;
  };
  const std::size_t tries = boxes_before_points(first, second);
  ClearanceClaim claim;
  const auto nearer = [](const Box& a, const Box& b) {
    return a.apart.distance > b.apart.distance;
  };
  std::vector<Box> heap;
  for (const auto& a : first.roots()) {
    for (const auto& b : second.roots()) {
      heap.push_back(box(first, second, a, b));
    }
  }
  std::make_heap(heap.begin(), heap.end(), nearer);
  if (!(heap.front().apart.distance > 0)) {
    claim.overlap = overlap_between_axes(first, second);
    if (claim.overlap) {
      claim.verdict = Verdict::proved;
      return claim;
    }
  }
  double occurs = std::numeric_limits<double>::infinity();
  for (std::size_t looked_at = 0;; ++looked_at) {
    const Box& front = heap.front();
    occurs = std::min(occurs, distance_that_occurs(first, second, front));
    if (front.apart.distance > 0 && front.apart.distance >= enough(looked_at) * occurs) {
      break;
    }
    const bool is_last =
        looked_at >= boxes || first.is_out_of_work() || are_too_short(front.first, front.second);
    // Overlapping parts never come apart; look for a common point before much work is done.
    if ((is_last ? looked_at < tries : looked_at == tries) && !(front.apart.distance > 0)) {
      claim.overlap = contact(first, second);
      if (!claim.overlap) {
        claim.overlap = overlap(first, second);
      }
      if (claim.overlap) {
        claim.verdict = Verdict::proved;
        return claim;
      }
    }
    if (is_last) {
      break;
    }
    std::pop_heap(heap.begin(), heap.end(), nearer);
    const Box whole = std::move(heap.back());
    heap.pop_back();
    for (Box& half : split(first, second, whole)) {
      heap.push_back(std::move(half));
      std::push_heap(heap.begin(), heap.end(), nearer);
    }
  }
  if (!(heap.front().apart.distance > 0)) {
    return claim;
  }
  claim.verdict = Verdict::proved;
  claim.distance = heap.front().apart.distance;
  for (const Box& leaf : heap) {
    claim.leaves.push_back({leaf.first, leaf.second, leaf.apart.direction});
  }
  std::sort(claim.leaves.begin(), claim.leaves.end(), [](const DiscPairs& a, const DiscPairs& b) {
    return std::pair(a.first.from, a.second.from) < std::pair(b.first.from, b.second.from);
  });
  return claim;
}

}  // namespace dupin::certification
