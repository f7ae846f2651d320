#include "tessellation/touching_holes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "tessellation/plane_segments.h"

namespace dupin::tessellation {
namespace {

using Corners = std::vector<std::uint32_t>;

// The least and greatest x.
struct Extent {
  double left, right;
};

Extent extent(const UnrolledCurve& curve) {
  const auto [left, right] =
      std::ranges::minmax_element(curve.places, {}, [](const Vec2& p) { return p.x(); });
  return {left->x(), right->x()};
}

struct Side {
  std::uint32_t from, to;
  Vec2 along;
};

struct Across {
  Side side;
  long turns;  // from the next hole's places
  Vec2 at;     // where it begins
};

constexpr double kShort = 8;  // along the axis, and in all

// The shortest from one hole to the next one around, which may be itself, if it is short.
std::optional<Across> bridge(const UnrolledCurve& one, const Extent& one_extent,
                             const UnrolledCurve& next, const Extent& next_extent, double around) {
  constexpr double kSegment = 1;  // wider it would be too far off the face
  const auto [one_left, one_right] = one_extent;
  const auto [next_left, next_right] = next_extent;
  const double ahead = ((next_left + next_right) - (one_left + one_right)) / 2;
  const double turns = &one == &next ? 1 : -std::floor(ahead / around), shift = turns * around;
  const double beside = next_left + shift - one_right;
  if (beside > kSegment || one.low > next.high + kShort || next.low > one.high + kShort) {
    return std::nullopt;
  }
  std::optional<Side> result;
  Vec2 at = Vec2::Zero();
  double least = kShort;
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    for (std::size_t j = 0; j < next.places.size(); ++j) {
      const Vec2 along = next.places[j] + Vec2(shift, 0) - one.places[i];
      if (along.norm() < least) {
        least = along.norm();
        result = {one.corners[i], next.corners[j], along};
        at = one.places[i];
      }
    }
  }
  const bool links =
      result && result->from != result->to && std::abs(result->along.x()) <= kSegment;
  return links ? std::optional(Across{*result, std::lround(turns), at}) : std::nullopt;
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

// Which bridges close chains of holes about the axis: the shortest, one chain for each set of
// holes. Other bridges would lead to holes that stand beside, and tear the face in two there.
//
// Holes are united along the sides that they are joined by, as J. B. Kruskal does (1956), with the
// turns that each is ahead of the first of its set.
class HoleChains {
 public:
  HoleChains(const std::vector<UnrolledCurve>& holes, double around)
      : holes_(holes), around_(around), up_(holes.size()), is_closed_(holes.size(), false) {
    for (std::size_t i = 0; i < holes.size(); ++i) {
      up_[i].hole = i;
      extents_.push_back(extent(holes[i]));
      by_low_.push_back(i);
      // A little more: the difference, and what it is taken from, are rounded.
      longest_ = std::max(longest_, (holes[i].high - holes[i].low) * 1.01 + kShort);
    }
    std::ranges::stable_sort(by_low_, {}, [&](std::size_t i) { return holes[i].low; });
  }

  [[nodiscard]] std::vector<Side> bridges() {
    unite_touching();
    std::vector<std::size_t> touching(holes_.size());  // sets of these
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      touching[i] = first_of(i).hole;
    }
    std::vector<Bridge> used = chosen();
    std::erase_if(used, [&](const Bridge& b) { return !is_closed_[first_of(b.one).hole]; });
    for (Bridge& bridge : used) {
      bridge.one = touching[bridge.one];
      bridge.next = touching[bridge.next];
    }
    // What only hangs on a chain.
    const auto ends_at = [&](std::size_t hole) {
      std::ptrdiff_t count = 0;
      for (const Bridge& bridge : used) {
        count += int(bridge.one == hole) + int(bridge.next == hole);
      }
      return count;
    };
    while (std::erase_if(used, [&](const Bridge& b) {
             return ends_at(b.one) < 2 || ends_at(b.next) < 2;
           }) != 0) {
    }
    std::vector<Side> result;
    std::ranges::transform(used, std::back_inserter(result), &Bridge::side);
    return result;
  }

 private:
  struct Ahead {
    std::size_t hole = 0;
    long turns = 0;
  };
  struct Bridge {
    std::size_t one, next;
    long turns;  // that the next is to be ahead
    Side side;
  };

  // The holes, ascending, that reach between these along the axis, ends included.
  [[nodiscard]] std::vector<std::size_t> near(double bottom, double top) const {
    const auto low = [&](std::size_t hole) { return holes_[hole].low; };
    std::vector<std::size_t> result;
    for (auto hole = std::ranges::lower_bound(by_low_, bottom - longest_, {}, low);
         hole != by_low_.end() && low(*hole) <= top; ++hole) {
      if (holes_[*hole].high >= bottom) {
        result.push_back(*hole);
      }
    }
    std::ranges::sort(result);
    return result;
  }

  [[nodiscard]] Ahead first_of(std::size_t hole) const {
    Ahead result{hole};
    while (up_[result.hole].hole != result.hole) {
      result = {up_[result.hole].hole, result.turns + up_[result.hole].turns};
    }
    return result;
  }

  // Whether that says anything new: of two sets, or of one that was not about the axis.
  bool unite(std::size_t one, std::size_t next, long turns) {
    const Ahead a = first_of(one), b = first_of(next);
    const long off = a.turns + turns - b.turns;
    if (a.hole == b.hole) {
      const bool closes = off != 0 && !is_closed_[a.hole];
      is_closed_[a.hole] = is_closed_[a.hole] || off != 0;
      return closes;
    }
    up_[b.hole] = {a.hole, off};
    is_closed_[a.hole] = is_closed_[a.hole] || is_closed_[b.hole];
    return true;
  }

  void unite_touching() {
    std::map<std::uint32_t, std::pair<std::size_t, double>> first_at;  // a hole, and its x there
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      for (std::size_t k = 0; k < holes_[i].corners.size(); ++k) {
        const double x = holes_[i].places[k].x();
        const auto [entry, is_new] = first_at.try_emplace(holes_[i].corners[k], i, x);
        if (!is_new) {
          unite(entry->second.first, i, std::lround((entry->second.second - x) / around_));
        }
      }
    }
  }

  // Whether it passes through a hole, on the way to one behind it.
  [[nodiscard]] bool is_blocked(const Side& across, const Vec2& from) const {
    const auto [bottom, top] = std::minmax({from.y(), from.y() + across.along.y()});
    return std::ranges::any_of(near(bottom, top), [&](std::size_t number) {
      const UnrolledCurve& hole = holes_[number];
      for (std::size_t i = 0; i < hole.corners.size(); ++i) {
        const std::size_t next = (i + 1) % hole.corners.size();
        const bool is_end = hole.corners[i] == across.from || hole.corners[i] == across.to ||
                            hole.corners[next] == across.from || hole.corners[next] == across.to;
        const double turns = std::round((from.x() - hole.places[i].x()) / around_);
        const Vec2 a = hole.places[i] + Vec2(turns * around_, 0) - from;
        const Vec2 b = a + hole.places[next] - hole.places[i];
        if (!is_end && cross_inside(Vec2::Zero(), across.along, a, b)) {
          return true;
        }
      }
      return false;
    });
  }

  [[nodiscard]] std::vector<Bridge> chosen() {
    std::vector<Bridge> all;
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      for (const std::size_t j : near(holes_[i].low - kShort, holes_[i].high + kShort)) {
        const auto across = bridge(holes_[i], extents_[i], holes_[j], extents_[j], around_);
        if (across && !is_blocked(across->side, across->at)) {
          all.push_back({i, j, across->turns, across->side});
        }
      }
    }
    std::ranges::stable_sort(all, {}, [](const Bridge& b) { return b.side.along.norm(); });
    std::erase_if(all, [&](const Bridge& b) {
      const bool reaches_chain =
          b.one != b.next && first_of(b.one).hole != first_of(b.next).hole &&
          (is_closed_[first_of(b.one).hole] || is_closed_[first_of(b.next).hole]);
      return reaches_chain || !unite(b.one, b.next, b.turns);
    });
    return all;
  }

  const std::vector<UnrolledCurve>& holes_;
  double around_;
  std::vector<Extent> extents_;
  std::vector<std::size_t> by_low_;
  double longest_ = 0;  // along the axis
  std::vector<Ahead> up_;
  std::vector<bool> is_closed_;  // about the axis, of the first of each set
};

}  // namespace

std::vector<UnrolledCurve> linked_about(std::vector<UnrolledCurve> holes,
                                        const std::vector<Vec2>& places, double around,
                                        Bridges bridges) {
  Links links(holes);
  if (bridges == Bridges::across_gaps) {
    for (const Side& across : HoleChains(holes, around).bridges()) {
      links.append_twice(across);
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
