#include "checking/injective_stars.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "predicates/stable_predicates.h"
#include "support/blocks.h"

namespace dupin::checking {
namespace {

/// The edge of a triangle opposite to a point.
struct Link {
  std::uint32_t from, to;
};

class Star {
 public:
  Star(std::span<const Vec3> points, double margin) : points_(points), margin_(margin) {}

  void clear() { links_.clear(); }
  void add(const Link& link) { links_.push_back(link); }

  [[nodiscard]] bool is_injective(std::uint32_t centre) {
    if (links_.size() < 3) {
      return false;
    }
    const int first = axis_of(centre, links_.front());
    const int second = axis_of(centre, links_[links_.size() / 2]);
    if (links_.size() > kFew) {
      std::sort(links_.begin(), links_.end(),
                [](const Link& a, const Link& b) { return a.from < b.from; });
    }
    return goes_round_once(centre, first) || (second != first && goes_round_once(centre, second));
  }

 private:
  static constexpr std::size_t kFew = 16;  // above, links are sorted

  [[nodiscard]] int axis_of(std::uint32_t centre, const Link& link) const {
    const Vec3& v = points_[centre];
    int axis = 0;
    (points_[link.from] - v).cross(points_[link.to] - v).cwiseAbs().maxCoeff(&axis);
    return axis;
  }

  [[nodiscard]] const Link* link_from(std::uint32_t point) const {
    const auto begin = links_.begin(), end = links_.end();
    const auto place =
        links_.size() > kFew
            ? std::lower_bound(begin, end, point,
                               [](const Link& link, std::uint32_t p) { return link.from < p; })
            : std::find_if(begin, end, [&](const Link& link) { return link.from == point; });
    return place != end && place->from == point ? &*place : nullptr;
  }

  /// The way that a link turns about the point; 0 if that is not certain.
  [[nodiscard]] int way_of(const Vec3& v, const Link& link, int axis) const {
    return predicates::stable_side_of_line(v, points_[link.from], points_[link.to], axis, margin_);
  }

  /// Whether the links make one cycle that, seen along `axis`, certainly turns the same way at each
  /// step, by less than half a turn, and by one turn in all: then it passes from below the point to
  /// above it once. As long as no step turns the other way, their sum stays.
  [[nodiscard]] bool goes_round_once(std::uint32_t centre, int axis) const {
    const Vec3& v = points_[centre];
    const int upward = (axis + 2) % 3;
    const auto below = [&](std::uint32_t point) { return points_[point][upward] < v[upward]; };
    const Link* at = &links_.front();
    const int way = way_of(v, *at, axis);
    std::size_t turns = 0;
    for (std::size_t step = 1; step <= links_.size(); ++step) {
      if (way == 0 || way_of(v, *at, axis) != way) {
        return false;
      }
      turns += below(at->from) && !below(at->to) ? 1 : 0;
      at = link_from(at->to);
      if (at == nullptr || turns > 1) {
        return false;
      }
      if (at == &links_.front()) {
        return step == links_.size() && turns == 1;
      }
    }
    return false;
  }

  std::span<const Vec3> points_;
  double margin_;
  std::vector<Link> links_;
};

}  // namespace

std::vector<std::uint32_t> injective_stars(std::span<const Vec3> points,
                                           std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> marked, double margin) {
  std::vector<std::uint32_t> start(points.size() + 1, 0);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      start[v + 1] += marked[v] == 0 ? 1 : 0;
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    start[v + 1] += start[v];
  }
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1), corners(start.back());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (marked[triangles[f][k]] == 0) {
        corners[next[triangles[f][k]]++] = 3 * f + k;
      }
    }
  }
  std::vector<std::uint32_t> injective(points.size());
  constexpr std::size_t kPoints = 1024;
  const auto find_injective = [&](const support::Block& block) {
    Star star(points, margin);
    for (std::size_t v = block.begin; v < block.end; ++v) {
      star.clear();
      for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
        const Triangle& t = triangles[corners[i] / 3];
        const std::uint32_t k = corners[i] % 3;
        star.add({t[(k + 1) % 3], t[(k + 2) % 3]});
      }
      injective[v] = star.is_injective(static_cast<std::uint32_t>(v)) ? start[v + 1] - start[v] : 0;
    }
  };
  support::for_each_block(points.size(), find_injective, kPoints);
  return injective;
}

}  // namespace dupin::checking
