#include "verification/claims/near_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

#include "verification/work.h"

namespace dupin::verification {
namespace {

using Box = IntervalVec;  // of what places are along three axes
using Parts = std::vector<std::uint32_t>;

using UnitAxes = std::array<IntervalVec, 3>;

// Of an axis without a direction it is the whole line, by which nothing is told.
UnitAxes unit_axes(const Directions& axes) {
  UnitAxes result;
  std::transform(axes.begin(), axes.end(), result.begin(), [](const Vec3& axis) {
    const IntervalVec w = numbers::interval_vec(axis);
    const Interval length = numbers::norm(w);
    return IntervalVec{w[0] / length, w[1] / length, w[2] / length};
  });
  return result;
}

// Of places in space, by what they are along the axes.
class PlaceAlong {
 public:
  explicit PlaceAlong(const BoxAxes& axes)
      : axes_(axes ? std::optional(unit_axes(*axes)) : std::nullopt) {}

  Box operator()(const IntervalVec& place) const {
    return axes_ ? Box{numbers::dot(place, axes_->at(0)), numbers::dot(place, axes_->at(1)),
                       numbers::dot(place, axes_->at(2))}
                 : place;
  }

 private:
  std::optional<UnitAxes> axes_;
};

Box box_of(const Solid& solid, const PlaceAlong& along) {
  std::vector<Box> boxes;
  for (double i = 0; i < solid.length(); ++i) {
    for (const auto& [center, radius] : balls_around_piece(solid, i)) {
      boxes.push_back(box_around(along(center), radius));
    }
  }
  for (const Sphere& knee : solid.knees()) {
    boxes.push_back(box_around(along(numbers::interval_vec(knee.center)), knee.radius));
  }
  return hull_of(boxes);
}

Box box_of(const LoopArcs& loop, const PlaceAlong& along) {
  std::vector<Box> boxes;
  for (const ArcCell& cell : loop.cells) {
    std::transform(cell.arcs.corners.begin(), cell.arcs.corners.end(), std::back_inserter(boxes),
                   along);
  }
  return hull_of(boxes);
}

bool are_near(const Box& a, const Box& b, double distance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval between = b.at(k) - a.at(k);
    if (between.lower >= distance || between.upper <= -distance) {
      return false;
    }
  }
  return true;
}

// What has no middle may be anywhere in an order.
double rank(const Interval& x) {
  return std::isfinite(x.lower) && std::isfinite(x.upper) ? std::midpoint(x.lower, x.upper) : 0;
}

class NearPairs {
 public:
  // Of which the second is one from there on.
  NearPairs(std::vector<Box> boxes, double distance, std::size_t from)
      : boxes_(std::move(boxes)), distance_(distance), from_(from) {}

  std::vector<PartPair> found() {
    Parts all(boxes_.size());
    std::iota(all.begin(), all.end(), 0U);
    look_among(std::move(all));
    std::sort(pairs_.begin(), pairs_.end());
    return std::move(pairs_);
  }

 private:
  static constexpr std::size_t kFew = 8;

  [[nodiscard]] Box around(const Parts& parts) const {
    Box result = boxes_[parts.front()];
    for (const std::uint32_t part : parts) {
      result = hull_of(result, boxes_[part]);
    }
    return result;
  }

  // Those that may have a partner within a box.
  [[nodiscard]] Parts near(const Parts& parts, const Box& box) const {
    spend(1 + parts.size() / kFew);
    Parts result;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(result),
                 [&](std::uint32_t part) { return are_near(boxes_[part], box, distance_); });
    return result;
  }

  [[nodiscard]] std::pair<Parts, Parts> halves(Parts parts) const {
    const Box all = around(parts);
    const auto width = [&](std::size_t k) { return all.at(k).upper - all.at(k).lower; };
    std::size_t axis = width(0) >= width(1) ? 0 : 1;
    axis = width(axis) >= width(2) ? axis : 2;
    const auto half = parts.begin() + std::ptrdiff_t(parts.size() / 2);
    std::nth_element(parts.begin(), half, parts.end(), [&](std::uint32_t a, std::uint32_t b) {
      return rank(boxes_[a].at(axis)) < rank(boxes_[b].at(axis));
    });
    return {Parts(parts.begin(), half), Parts(half, parts.end())};
  }

  void look_at(std::uint32_t a, std::uint32_t b) {
    if (std::max(a, b) >= from_ && are_near(boxes_[a], boxes_[b], distance_)) {
      pairs_.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  void look_among(Parts parts) {
    if (parts.size() > kFew) {
      auto [low, high] = halves(std::move(parts));
      look_between(low, high);
      look_among(std::move(low));
      look_among(std::move(high));
      return;
    }
    spend(1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        look_at(parts[i], parts[k]);
      }
    }
  }

  void look_between(const Parts& first, const Parts& second) {
    const Parts a = near(first, around(second));
    const Parts b = a.empty() ? Parts() : near(second, around(a));
    if (std::min(a.size(), b.size()) > kFew) {
      const bool splits_first = a.size() >= b.size();
      const auto [low, high] = halves(splits_first ? a : b);
      look_between(low, splits_first ? b : a);
      look_between(high, splits_first ? b : a);
      return;
    }
    spend(1 + std::max(a.size(), b.size()));
    for (const std::uint32_t one : a) {
      for (const std::uint32_t other : b) {
        look_at(one, other);
      }
    }
  }

  std::vector<Box> boxes_;
  double distance_;
  std::size_t from_;
  std::vector<PartPair> pairs_;
};

// Of the parts, and room for more.
std::vector<Box> boxes_of(const std::vector<Solid>& solids, const PlaceAlong& along,
                          std::size_t more) {
  std::vector<Box> boxes(solids.size());
  (void)holds_of_all(solids.size(), [&](std::size_t i) {
    boxes[i] = box_of(solids[i], along);
    return true;
  });
  boxes.reserve(solids.size() + more);
  return boxes;
}

}  // namespace

std::vector<PartPair> pairs_nearer_than(double distance, const BoxAxes& axes,
                                        const std::vector<Solid>& solids) {
  std::vector<Box> boxes = boxes_of(solids, PlaceAlong(axes), 0);
  return NearPairs(std::move(boxes), distance, 0).found();
}

std::vector<PartPair> loop_pairs_nearer_than(double distance, const BoxAxes& axes,
                                             const std::vector<Solid>& solids,
                                             const std::vector<LoopArcs>& loops) {
  const PlaceAlong along(axes);
  std::vector<Box> boxes = boxes_of(solids, along, loops.size());
  for (const LoopArcs& loop : loops) {
    boxes.push_back(box_of(loop, along));
  }
  auto pairs = NearPairs(std::move(boxes), distance, solids.size()).found();
  std::sort(pairs.begin(), pairs.end(), [&](const PartPair& a, const PartPair& b) {
    return place_of(a, solids.size()) < place_of(b, solids.size());
  });
  return pairs;
}

}  // namespace dupin::verification
