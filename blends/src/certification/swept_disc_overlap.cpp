#include "certification/swept_disc_overlap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "certification/common_points.h"
#include "curves/exact_spine.h"
#include "dupin/kernel/parallel.h"

namespace dupin::certification {
namespace {

// Of a disc; none of a ball.
struct Plane {
  numbers::IntervalVec center, normal;
};

std::optional<Plane> plane(const DiscHull& disc) {
  return disc.tangents.empty() ? std::nullopt
                               : std::optional(Plane{disc.centers.front(), disc.tangents.front()});
}

double height(const std::optional<Plane>& plane, const Vec3& point) {
  return plane ? numbers::dot(numbers::interval_vec(point) - plane->center, plane->normal).lower
               : 0;
}

// Proves of points that they lie inside a disc of a stretch, by more than what the checker's
// rounding may hide.
class Inside {
 public:
  Inside(const SweptDiscs& sweep, const ParameterInterval& t)
      : discs_(sweep.over(t)),
        first_(sweep.over({t.from, t.from})),
        last_(sweep.over({t.to, t.to})) {}

  [[nodiscard]] const DiscHull& discs() const { return discs_; }

  [[nodiscard]] bool has(const Vec3& point) const {
    const numbers::IntervalVec p = numbers::interval_vec(point);
    const double room = kDiscSlack * (point.norm() + discs_.radius.upper);
    const bool passes =
        discs_.tangents.empty() ||
        (numbers::dot(p - first_.centers.front(), first_.tangents.front()).lower > room &&
         numbers::dot(p - last_.centers.back(), last_.tangents.back()).upper < -room);
    return passes &&
           std::all_of(discs_.centers.begin(), discs_.centers.end(),
                       [&](const numbers::IntervalVec& center) {
                         return numbers::norm(p - center).upper + room < discs_.radius.lower;
                       });
  }

 private:
  DiscHull discs_, first_, last_;
};

bool crosses(const SweptDiscs& sweep, const ParameterInterval& t, const Vec3& point) {
  return Inside(sweep, t).has(point);
}

// Where the planes of a sweep's discs are thought to pass a point. Discs and boxes about stretches
// are computed once: many points are asked about, and near each there are few stretches.
class Crossings {
 public:
  // With boxes about short stretches, which tell most points apart, for `many` points.
  Crossings(const SweptDiscs& sweep, bool many) : sweep_(sweep) {
    if (sweep.over({0, 1}).tangents.empty()) {
      return;  // a ball
    }
    const auto pieces = sweep.stretches();
    const SweptDiscs unpaid = sweep.with(nullptr);
    std::vector<std::vector<Stretch>> by_piece(pieces.size());
    for_each_in_parallel(pieces.size(), [&](std::size_t i) {
      by_piece[i] = stretches_along(unpaid, pieces[i], many);
    });
    for (auto& own : by_piece) {
      sweep.spend(2 * own.size() + (many ? 1 : 2));
      stretches_.insert(stretches_.end(), own.begin(), own.end());
    }
    build_tree();
  }

  // The stretches, made short.
  [[nodiscard]] std::vector<ParameterInterval> at(const Vec3& point) const {
    if (stretches_.empty()) {
      return {{0, 1}};
    }
    std::vector<ParameterInterval> result;
    for (const std::size_t i : near(point)) {
      const Stretch& stretch = stretches_[i];
      if (height(stretch.first, point) > 0 && height(stretch.last, point) <= 0) {
        result.push_back(shortened(stretch, point));
      }
    }
    return result;
  }

 private:
  static constexpr int kStretches = 64;
  static constexpr double kShort = 0x1p-18;

  // The less a piece turns, the fewer: planes of a straight one's discs pass each point once.
  static int stretches_of(const DiscHull& piece) {
    const double turn = 2 * std::acos(std::clamp(piece.cosine, 0., 1.)) / std::numbers::pi;
    return turn >= 0 ? std::max(1, int(std::ceil(kStretches * turn))) : kStretches;
  }

  // No point of a disc is outside of either, whatever rounding does.
  struct Reach {
    Eigen::AlignedBox3d box;
    Vec3 center;
    double radius;

    [[nodiscard]] bool has(const Vec3& point) const { return (point - center).norm() <= radius; }
  };

  struct Stretch {
    ParameterInterval piece, t;
    Reach reach;
    std::optional<Plane> first, last;
  };

  // Looks at twice as many discs and one, and at the whole piece if they are not `many`.
  static std::vector<Stretch> stretches_along(const SweptDiscs& sweep,
                                              const ParameterInterval& piece, bool many) {
    const int count = many ? kStretches : stretches_of(sweep.over(piece));
    std::vector<Stretch> result;
    std::optional<Plane> first = plane(sweep.over({piece.from, piece.from}));
    for (int i = 0; i < count; ++i) {
      const ParameterInterval t{piece.from + double(i) / count, piece.from + double(i + 1) / count};
      const std::optional<Plane> last = plane(sweep.over({t.to, t.to}));
      result.push_back({piece, t, reach(sweep.over(t)), first, last});
      first = last;
    }
    return result;
  }

  static Reach reach(const DiscHull& hull) {
    Eigen::AlignedBox3d box;
    for (const numbers::IntervalVec& c : hull.centers) {
      box.extend(Vec3(c[0].lower, c[1].lower, c[2].lower));
      box.extend(Vec3(c[0].upper, c[1].upper, c[2].upper));
    }
    const Vec3 center = box.center();
    const double radius = hull.radius.upper + box.diagonal().norm() + 0x1p-40 * center.norm();
    const Vec3 around = Vec3::Constant(radius);
    return {{Vec3(box.min() - around), Vec3(box.max() + around)}, center, radius};
  }

  // Stretches come in their order along the part, so that halves of them are near each other: each
  // node of the tree has the box of the two below it.
  void build_tree() {
    leaves_ = std::bit_ceil(stretches_.size());
    tree_.resize(2 * leaves_);
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const Eigen::AlignedBox3d& box = stretches_[i].reach.box;
      if ((box.min().array() <= box.max().array()).all()) {  // others contain no point
        tree_[leaves_ + i] = box;
      }
    }
    for (std::size_t i = leaves_; i-- > 1;) {
      tree_[i] = tree_[2 * i].merged(tree_[2 * i + 1]);
    }
  }

  // In their own order, those that may reach the point.
  [[nodiscard]] std::vector<std::size_t> near(const Vec3& point) const {
    constexpr std::uint64_t kBoxesOfUnit = 64;
    std::vector<std::size_t> result, open{1};
    std::uint64_t looked_at = 0;
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      ++looked_at;
      if (!tree_[node].contains(point)) {
        continue;
      }
      if (node >= leaves_) {
        if (stretches_[node - leaves_].reach.has(point)) {
          result.push_back(node - leaves_);
        }
      } else {
        open.push_back(2 * node + 1);
        open.push_back(2 * node);
      }
    }
    sweep_.spend(looked_at / kBoxesOfUnit);
    return result;
  }

  [[nodiscard]] ParameterInterval shortened(const Stretch& stretch, const Vec3& point) const {
    ParameterInterval t = stretch.t;
    while (size(t) > kShort) {
      const auto [left, right] = halves(t);
      t = height(plane(sweep_.over({left.to, left.to})), point) <= 0 ? left : right;
    }
    return {std::max(stretch.piece.from, t.from - size(t)),
            std::min(stretch.piece.to, t.to + size(t))};
  }

  const SweptDiscs& sweep_;
  std::vector<Stretch> stretches_;
  std::vector<Eigen::AlignedBox3d> tree_;
  std::size_t leaves_ = 0;
};

// Points of some discs, tried on all others, with half of what work is left: other claims want
// some.
std::optional<Overlap> overlap(const SweptDiscs& a, const SweptDiscs& b, bool same) {
  constexpr int kDiscs = 24, kAngles = 8;
  if (!a.full() || !b.full() || a.is_out_of_work()) {
    return std::nullopt;
  }
  const Crossings crossings(b, true);
  const std::uint64_t before = a.work_spent();
  for (int i = 0; i < kDiscs * int(a.length()) && a.has_half_since(before); ++i) {
    const double t = (i + 0.5) / kDiscs;
    const ParameterInterval around{t - 0x1p-16, t + 0x1p-16};
    const Inside inside(a, around);
    const DiscHull& disc = inside.discs();
    const Vec3 axis = disc.tangents.empty() ? Vec3::UnitZ() : disc.axis;
    const Vec3 across = axis.unitOrthogonal();
    for (int k = 0; k < 2 * kAngles + 1; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAngles;
      const double reach = disc.radius.lower * (k == 0 ? 0 : k <= kAngles ? 0.5 : 0.9);
      const Vec3 point =
          disc.middle() + reach * (std::cos(angle) * across + std::sin(angle) * axis.cross(across));
      if (!inside.has(point)) {
        continue;
      }
      for (const ParameterInterval& other : crossings.at(point)) {
        const bool own = same && other.from <= around.to && around.from <= other.to;
        if (!own && crosses(b, other, point)) {
          return Overlap{point, around, other};
        }
      }
    }
  }
  return std::nullopt;
}

// One of the points that is inside of both.
std::optional<Overlap> overlap_at(const std::vector<Vec3>& points, const SweptDiscs& a,
                                  const SweptDiscs& b) {
  if (points.empty()) {
    return std::nullopt;
  }
  const Crossings on_a(a, false), on_b(b, false);
  for (const Vec3& point : points) {
    for (const ParameterInterval& one : on_a.at(point)) {
      for (const ParameterInterval& other : on_b.at(point)) {
        if (crosses(a, one, point) && crosses(b, other, point)) {
          return Overlap{point, one, other};
        }
      }
    }
  }
  return std::nullopt;
}

// One that is not met by chance.
std::optional<Overlap> overlap_where_nearest(const SweptDiscs& a, const SweptDiscs& b) {
  return a.full() && b.full() && !a.is_out_of_work() ? overlap_at(common_points(a, b), a, b)
                                                     : std::nullopt;
}

// Exactly, border included.
bool lies_in(const Ring& ring, const Vec3& point) {
  const numbers::ExactVec3 d = numbers::exact(point) - numbers::exact(ring.center);
  const mpq_class radius = ring.radius;
  return !ring.ellipse && dot(d, numbers::exact(ring.normal)) == 0 && dot(d, d) <= radius * radius;
}

}  // namespace

std::optional<Overlap> overlap_between_axes(const SweptDiscs& a, const SweptDiscs& b) {
  constexpr double kDiscs = 32;  // of each piece, at least
  const bool has_work = a.has_work_for(std::uint64_t(kDiscs * (a.length() + b.length())));
  if (!a.full() || !b.full() || !has_work) {
    return std::nullopt;
  }
  const auto point = point_between_axes(a, b);
  return point ? overlap_at({*point}, a, b) : std::nullopt;
}

std::optional<Overlap> self_overlap(const SweptDiscs& sweep) { return overlap(sweep, sweep, true); }

// Centres of end rings that lie in an end ring of the other part.
std::optional<Overlap> contact(const SweptDiscs& a, const SweptDiscs& b) {
  if (!a.full() || !b.full()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < a.end_rings().size(); ++i) {
    for (std::size_t j = 0; j < b.end_rings().size(); ++j) {
      const Ring &first = a.end_rings()[i], &second = b.end_rings()[j];
      const double s = i == 0 ? 0 : a.length(), t = j == 0 ? 0 : b.length();
      for (const Vec3& point : {first.center, second.center}) {
        if (lies_in(first, point) && lies_in(second, point)) {
          return Overlap{point, {s, s}, {t, t}};
        }
      }
    }
  }
  return std::nullopt;
}

std::optional<Overlap> overlap(const SweptDiscs& part, const std::vector<PlacedPoint>& points) {
  if (!part.full() || part.is_out_of_work()) {
    return std::nullopt;
  }
  const Crossings crossings(part, true);
  for (const PlacedPoint& placed : points) {
    for (const ParameterInterval& stretch : crossings.at(placed.point)) {
      if (crosses(part, stretch, placed.point)) {
        return Overlap{placed.point, stretch, {placed.parameter, placed.parameter}};
      }
    }
  }
  return std::nullopt;
}

// Points of either part, tried on the other.
std::optional<Overlap> overlap(const SweptDiscs& a, const SweptDiscs& b) {
  auto result = overlap(a, b, false);
  if (!result) {
    result = overlap(b, a, false);
    if (result) {
      std::swap(result->first, result->second);
    }
  }
  return result ? result : overlap_where_nearest(a, b);
}

}  // namespace dupin::certification
