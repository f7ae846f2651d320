#include "disc_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace dupin::detail {
namespace {

// Whoever checks a claim rounds in his own way; nothing is claimed that hangs on the last bits.
constexpr double kSlack = 0x1p-40;

// Shorter stretches only show the rounding of their ends.
constexpr double kShortest = 0x1p-40;

double size(const ParameterInterval& t) { return t.to - t.from; }

std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t) {
  const double middle = (t.from + t.to) / 2;
  return {{t.from, middle}, {middle, t.to}};
}

// The seams of extensions are whole numbers.
std::vector<ParameterInterval> stretches(const DiscSweep& sweep) {
  std::vector<ParameterInterval> result;
  for (double t = sweep.from(); t < sweep.to(); ++t) {
    result.push_back({t, t + 1});
  }
  return result;
}

// A stretch of one sweep against one of the same or another.
struct Box {
  ParameterInterval first, second;
  DiscHull first_hull, second_hull;
  Separation apart;
};

Box box(const DiscSweep& a, const DiscSweep& b, const ParameterInterval& s,
        const ParameterInterval& t) {
  Box result{s, t, a.over(s), b.over(t), {}};
  result.apart = separation(result.first_hull, result.second_hull);
  return result;
}

std::vector<Box> split(const DiscSweep& a, const DiscSweep& b, const Box& whole) {
  const bool has_b = !whole.second_hull.tangents.empty();
  const bool has_a = !whole.first_hull.tangents.empty();
  if (has_a && (!has_b || whole.first_hull.extent() >= whole.second_hull.extent())) {
    const auto [left, right] = halves(whole.first);
    return {box(a, b, left, whole.second), box(a, b, right, whole.second)};
  }
  const auto [left, right] = halves(whole.second);
  return {box(a, b, whole.first, left), box(a, b, whole.first, right)};
}

// That of two discs of the box which are likely to be near each other.
double distance_that_occurs(const DiscSweep& a, const DiscSweep& b, const Box& box) {
  const auto nearer_end = [](const ParameterInterval& t, const DiscHull& hull, const Vec3& place) {
    const auto distance = [&](const IntervalVec& center) {
      return norm(center - interval_vec(place)).lower;
    };
    return distance(hull.centers.front()) <= distance(hull.centers.back()) ? t.from : t.to;
  };
  const double s = nearer_end(box.first, box.first_hull, box.second_hull.middle());
  const double t = nearer_end(box.second, box.second_hull, box.first_hull.middle());
  return separation(a.over({s, s}), b.over({t, t})).nearest;
}

// Whether the point is proven to lie inside a disc of the stretch.
bool crosses(const DiscHull& discs, const Vec3& point) {
  const IntervalVec p = interval_vec(point);
  const bool passes =
      discs.tangents.empty() || (dot(p - discs.centers.front(), discs.tangents.front()).lower > 0 &&
                                 dot(p - discs.centers.back(), discs.tangents.back()).upper < 0);
  return passes &&
         std::all_of(discs.centers.begin(), discs.centers.end(), [&](const IntervalVec& center) {
           return norm(p - center).upper < discs.radius.lower * (1 - kSlack);
         });
}

// The stretches in which the planes of discs are thought to pass the point, made short.
std::vector<ParameterInterval> crossings(const DiscSweep& sweep, const Vec3& point) {
  constexpr int kStretches = 64, kHalvings = 12;
  const auto height = [&](double t) {
    const DiscHull disc = sweep.over({t, t});
    return disc.tangents.empty()
               ? 0
               : dot(interval_vec(point) - disc.centers.front(), disc.tangents.front()).lower;
  };
  std::vector<ParameterInterval> result;
  double before = height(0);
  for (int i = 0; i < kStretches; ++i) {
    ParameterInterval t{double(i) / kStretches, double(i + 1) / kStretches};
    const double after = height(t.to);
    if (before > 0 && after <= 0) {
      for (int k = 0; k < kHalvings; ++k) {
        const auto [left, right] = halves(t);
        t = height(left.to) <= 0 ? left : right;
      }
      result.push_back({std::max(0.0, t.from - size(t)), std::min(1.0, t.to + size(t))});
    }
    before = after;
  }
  return result.empty() && sweep.over({0, 1}).tangents.empty()
             ? std::vector{ParameterInterval{0, 1}}
             : result;
}

// Points of some discs, tried on all others.
std::optional<Overlap> overlap(const DiscSweep& a, const DiscSweep& b, bool same) {
  constexpr int kDiscs = 24, kAngles = 8;
  for (int i = 0; i < kDiscs; ++i) {
    const double t = (i + 0.5) / kDiscs;
    const ParameterInterval around{t - 0x1p-16, t + 0x1p-16};
    const DiscHull disc = a.over(around);
    const Vec3 axis = disc.tangents.empty() ? Vec3::UnitZ() : disc.axis;
    const Vec3 across = axis.unitOrthogonal();
    for (int k = 0; k < 2 * kAngles + 1; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAngles;
      const double reach = disc.radius.lower * (k == 0 ? 0 : k <= kAngles ? 0.5 : 0.9);
      const Vec3 point =
          disc.middle() + reach * (std::cos(angle) * across + std::sin(angle) * axis.cross(across));
      if (!crosses(disc, point)) {
        continue;
      }
      for (const ParameterInterval& other : crossings(b, point)) {
        const bool own = same && other.from <= around.to && around.from <= other.to;
        if (!own && crosses(b.over(other), point)) {
          return Overlap{point, around, other};
        }
      }
    }
  }
  return std::nullopt;
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
  const Interval behind = support(first, best.direction), front = support(second, -best.direction);
  best.distance =
      ((Interval(0) - front - behind) / norm(interval_vec(best.direction)) - kSlack * scale).lower;
  return best;
}

EmbeddedClaim prove_embedded(const DiscSweep& sweep, double margin, std::size_t boxes) {
  EmbeddedClaim claim;
  struct Pair {
    ParameterInterval first, second;
  };
  std::vector<Pair> stack;
  const auto pieces = stretches(sweep);
  for (std::size_t i = pieces.size(); i-- > 0;) {
    for (std::size_t j = pieces.size(); j-- > i;) {
      stack.push_back({pieces[i], pieces[j]});
    }
  }
  for (std::size_t looked_at = 0; !stack.empty(); ++looked_at) {
    const Pair pair = stack.back();
    stack.pop_back();
    if (sweep.turns_little({pair.first.from, pair.second.to}, margin)) {
      claim.leaves.push_back({pair.first, pair.second, {}});
      continue;
    }
    if (looked_at >= boxes || std::max(size(pair.first), size(pair.second)) < kShortest) {
      claim.leaves.clear();
      claim.overlap = overlap(sweep, sweep, true);
      claim.verdict = claim.overlap ? Verdict::refuted : Verdict::undecided;
      return claim;
    }
    const auto [left, right] = halves(pair.first);
    if (pair.first == pair.second) {
      stack.push_back({right, right});
      stack.push_back({left, right});
      stack.push_back({left, left});
      continue;
    }
    const Box whole = box(sweep, sweep, pair.first, pair.second);
    if (whole.apart.distance > 0) {
      claim.leaves.push_back({pair.first, pair.second, whole.apart.direction});
    } else if (size(pair.first) >= size(pair.second)) {
      stack.push_back({right, pair.second});
      stack.push_back({left, pair.second});
    } else {
      const auto [near, far] = halves(pair.second);
      stack.push_back({pair.first, far});
      stack.push_back({pair.first, near});
    }
  }
  claim.verdict = Verdict::proved;
  return claim;
}

// Best first: the box with the smallest bound is divided until the bound is close to a distance
// that certainly occurs, that of two points.
ClearanceClaim prove_clearance(const DiscSweep& first, const DiscSweep& second, std::size_t boxes) {
  constexpr double kEnough = 0.9;  // of the distance
  ClearanceClaim claim;
  const auto nearer = [](const Box& a, const Box& b) {
    return a.apart.distance > b.apart.distance;
  };
  std::vector<Box> heap{box(first, second, {0, 1}, {0, 1})};
  double occurs = std::numeric_limits<double>::infinity();
  for (std::size_t looked_at = 0;; ++looked_at) {
    const Box& front = heap.front();
    occurs = std::min(occurs, distance_that_occurs(first, second, front));
    if (front.apart.distance > 0 && front.apart.distance >= kEnough * occurs) {
      break;
    }
    if (looked_at >= boxes || std::max(size(front.first), size(front.second)) < kShortest) {
      break;
    }
    // Overlapping parts never come apart; look for a common point before much work is done.
    if (looked_at == 64 && !(front.apart.distance > 0)) {
      claim.overlap = overlap(first, second, false);
      if (!claim.overlap) {
        claim.overlap = overlap(second, first, false);
        if (claim.overlap) {
          std::swap(claim.overlap->first, claim.overlap->second);
        }
      }
      if (claim.overlap) {
        claim.verdict = Verdict::proved;
        return claim;
      }
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

}  // namespace dupin::detail
