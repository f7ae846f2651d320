#include "arrangement/ray_casting.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "arrangement/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {
namespace {

mesh::ExactPoint middle(const PointTable& points, const Triangle& corners) {
  std::array<mesh::ExactPoint, 3> scratch;
  const mesh::ExactPoint& a = points.exact(corners[0], scratch[0]);
  const mesh::ExactPoint& b = points.exact(corners[1], scratch[1]);
  const mesh::ExactPoint& c = points.exact(corners[2], scratch[2]);
  mesh::ExactPoint sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = a[k] * (b[3] * c[3]) + b[k] * (a[3] * c[3]) + c[k] * (a[3] * b[3]);
  }
  sum[3] = a[3] * b[3] * c[3] * CGAL::Mpzf(3);
  return sum;
}

class Ray {
 public:
  Ray(const ArrangementInput& input, PointId start, const Projection& front)
      : input_(input), start_(start), axis_(front.axis), direction_(front.orientation) {}

  // May be wrong only by saying yes.
  [[nodiscard]] bool may_meet(const ArrangementInput::Bounds& box) const {
    return may_meet_extent([&box](int k) { return std::pair(box.min()[k], box.max()[k]); });
  }
  [[nodiscard]] bool may_meet(const Triangle& corners) const {
    return may_meet_extent([&](int k) {
      const Interval a = input_.points.interval(corners[0], k),
                     b = input_.points.interval(corners[1], k),
                     c = input_.points.interval(corners[2], k);
      return std::pair(std::min({a.inf(), b.inf(), c.inf()}),
                       std::max({a.sup(), b.sup(), c.sup()}));
    });
  }

  // +1 if the ray enters the triangle's back and leaves through its front, -1 if the other way
  // round, 0 if it misses it. The start counts as moved by an infinitesimal along the next axis,
  // and by a smaller one along the third: so no edge or corner is met, and a triangle parallel to
  // the ray never.
  [[nodiscard]] int crossing(const Triangle& corners, const Triangle& support) const {
    const int v = (axis_ + 2) % 3;
    std::array<bool, 3> above{};
    for (std::size_t i = 0; i < 3; ++i) {
      above[i] = compare(input_.points, corners[i], start_, v) > 0;
    }
    if (above[0] == above[1] && above[1] == above[2]) {
      return 0;
    }
    int winding = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (above[i] == above[j]) {
        continue;
      }
      const int side = turn(input_.points, corners[i], corners[j], start_, axis_);
      winding += above[j] && side > 0 ? 1 : above[i] && side < 0 ? -1 : 0;
    }
    if (winding == 0) {
      return 0;
    }
    const int height = side_of_plane(input_.points, support[0], support[1], support[2], start_);
    const int slope = winding * direction_;
    return height * slope < 0 ? slope : 0;
  }

 private:
  // Of something that lies between the ends of extent(k) along each axis k.
  template <class Extent>
  [[nodiscard]] bool may_meet_extent(const Extent& extent) const {
    for (const int k : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const Interval x = input_.points.interval(start_, k);
      const auto [low, high] = extent(k);
      if (x.sup() < low || x.inf() > high) {
        return false;
      }
    }
    const Interval x = input_.points.interval(start_, axis_);
    const auto [low, high] = extent(axis_);
    return direction_ > 0 ? x.inf() <= high : x.sup() >= low;
  }

  const ArrangementInput& input_;
  PointId start_;
  int axis_, direction_;
};

// How often the ray leaves the operand more than it enters it. The triangles that cover the start
// do not count.
int crossings(const ArrangementInput& input, const Ray& ray, std::size_t operand,
              std::span<const SignedTriangle> cover) {
  const std::uint32_t first = input.first_triangle[operand];
  const std::uint32_t count = input.first_triangle[operand + 1] - first;
  std::vector<int> sums(support::block_count(count), 0);
  support::for_each_block(count, [&](const support::Block& block) {
    const UpwardRounding rounding;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto t = static_cast<std::uint32_t>(first + i);
      const auto is_t = [t](const SignedTriangle& s) { return s.triangle == t; };
      if (ray.may_meet(input.triangles[t]) && std::none_of(cover.begin(), cover.end(), is_t)) {
        sums[block.number] += ray.crossing(input.triangles[t], input.support(t));
      }
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0);
}

}  // namespace

std::vector<int> winding_numbers_at(ArrangementInput& input, const BooleanRule& rule,
                                    const Triangle& corners, const Triangle& support,
                                    std::span<const SignedTriangle> cover) {
  const PointId start = input.points.add(middle(input.points, corners));
  const Ray ray(input, start, projection_of(input.points, support));
  std::vector<int> counts(rule.groups, 0);
  for (std::size_t o = 0; o < input.operands.size(); ++o) {
    if (ray.may_meet(input.bounds[o])) {
      counts[rule.group_of_operand[o]] += crossings(input, ray, o, cover);
    }
  }
  input.points.remove_last();
  return counts;
}

}  // namespace dupin::arrangement
