#include "tessellation/touching_holes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace dupin::tessellation {
namespace {

using Corners = std::vector<std::uint32_t>;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double twice_area(const UnrolledCurve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    sum += cross(curve.places[i] - curve.places[0],
                 curve.places[(i + 1) % curve.places.size()] - curve.places[0]);
  }
  return sum;
}

// The least and greatest x.
std::pair<double, double> extent(const UnrolledCurve& curve) {
  const auto [left, right] =
      std::ranges::minmax_element(curve.places, {}, [](const Vec2& p) { return p.x(); });
  return {left->x(), right->x()};
}

struct Side {
  std::uint32_t from, to;
  Vec2 along;
};

// The shortest from one hole to the next one around, which may be itself, if it is short.
std::optional<Side> bridge(const UnrolledCurve& one, const UnrolledCurve& next, double around) {
  constexpr double kShort = 8, kSegment = 1;  // wider it would be too far off the face
  const auto [one_left, one_right] = extent(one);
  const auto [next_left, next_right] = extent(next);
  const double ahead = ((next_left + next_right) - (one_left + one_right)) / 2;
  const double shift = &one == &next ? around : -around * std::floor(ahead / around);
  const double beside = next_left + shift - one_right;
  if (beside > kSegment || one.low > next.high + kShort || next.low > one.high + kShort) {
    return std::nullopt;
  }
  std::optional<Side> result;
  double least = kShort;
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    for (std::size_t j = 0; j < next.places.size(); ++j) {
      const Vec2 along = next.places[j] + Vec2(shift, 0) - one.places[i];
      if (along.norm() < least) {
        least = along.norm();
        result = {one.corners[i], next.corners[j], along};
      }
    }
  }
  const bool links =
      result && result->from != result->to && std::abs(result->along.x()) <= kSegment;
  return links ? result : std::nullopt;
}

// Walks along what is left of all sides, the holes being to their right. Nothing here needs to be
// exact: what is linked wrongly crosses itself, and is refused when it is triangulated.
class Links {
 public:
  explicit Links(const std::vector<UnrolledCurve>& holes) {
    for (const UnrolledCurve& hole : holes) {
      const std::size_t count = hole.corners.size();
      const bool turns_round = twice_area(hole) > 0;
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        append(hole, turns_round ? next : i, turns_round ? i : next);
      }
    }
  }

  void append_twice(const Side& side) {
    append(side);
    append({side.to, side.from, -side.along});
  }

  [[nodiscard]] bool touch() const {
    return std::ranges::any_of(from_, [](const auto& entry) { return entry.second.size() > 1; });
  }

  std::vector<Corners> walks() const {
    std::vector<Corners> result;
    std::vector<bool> is_used(sides_.size(), false);
    for (std::size_t first = 0; first < sides_.size(); ++first) {
      if (is_used[first]) {
        continue;
      }
      Corners walk;
      for (std::size_t side = first; !is_used[side]; side = after(side)) {
        is_used[side] = true;
        walk.push_back(sides_[side].from);
      }
      result.push_back(std::move(walk));
    }
    return result;
  }

 private:
  void append(const UnrolledCurve& hole, std::size_t from, std::size_t to) {
    append({hole.corners[from], hole.corners[to], Vec2(hole.places[to] - hole.places[from])});
  }

  void append(const Side& side) {
    from_[side.from].push_back(sides_.size());
    sides_.push_back(side);
  }

  // The first one clockwise from the way back.
  [[nodiscard]] std::size_t after(std::size_t side) const {
    const Vec2 back = -sides_[side].along;
    const auto clockwise = [&](std::size_t other) {
      const Vec2& along = sides_[other].along;
      const double angle = std::atan2(cross(along, back), along.dot(back));
      return angle > 0 ? angle : angle + 2 * std::numbers::pi;
    };
    return *std::ranges::min_element(from_.at(sides_[side].to), {}, clockwise);
  }

  std::vector<Side> sides_;
  std::map<std::uint32_t, std::vector<std::size_t>> from_;  // by corner
};

}  // namespace

std::vector<UnrolledCurve> linked_about(std::vector<UnrolledCurve> holes,
                                        const std::vector<Vec2>& places, double around) {
  Links links(holes);
  for (const UnrolledCurve& hole : holes) {
    for (const UnrolledCurve& next : holes) {
      if (const auto across = bridge(hole, next, around)) {
        links.append_twice(*across);
      }
    }
  }
  if (!links.touch()) {
    return holes;
  }
  std::vector<UnrolledCurve> linked;
  for (Corners& walk : links.walks()) {
    linked.push_back(unrolled(std::move(walk), places, around));
  }
  const bool about =
      std::ranges::any_of(linked, [](const UnrolledCurve& curve) { return curve.turns != 0; });
  return about ? linked : holes;
}

}  // namespace dupin::tessellation
