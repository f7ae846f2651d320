#include "ray.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "predicates.h"
#include "triangle_pair.h"

namespace dupin::detail {
namespace {

ExactPoint middle(const PointTable& points, const Triangle& corners) {
  std::array<ExactPoint, 3> scratch;
  const ExactPoint& a = points.exact(corners[0], scratch[0]);
  const ExactPoint& b = points.exact(corners[1], scratch[1]);
  const ExactPoint& c = points.exact(corners[2], scratch[2]);
  ExactPoint sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = a[k] * (b[3] * c[3]) + b[k] * (a[3] * c[3]) + c[k] * (a[3] * b[3]);
  }
  sum[3] = a[3] * b[3] * c[3] * CGAL::Mpzf(3);
  return sum;
}

class Ray {
 public:
  Ray(const Scene& scene, PointId start, const Projection& front)
      : scene_(scene), start_(start), axis_(front.axis), direction_(front.orientation) {}

  // May be wrong only by saying yes.
  [[nodiscard]] bool may_meet(const Scene::Bounds& box) const {
    return may_meet_extent([&box](int k) { return std::pair(box.min()[k], box.max()[k]); });
  }
  [[nodiscard]] bool may_meet(const Triangle& corners) const {
    return may_meet_extent([&](int k) {
      const Interval a = scene_.points.interval(corners[0], k),
                     b = scene_.points.interval(corners[1], k),
                     c = scene_.points.interval(corners[2], k);
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
      above[i] = compare(scene_.points, corners[i], start_, v) > 0;
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
      const int side = turn(scene_.points, corners[i], corners[j], start_, axis_);
      winding += above[j] && side > 0 ? 1 : above[i] && side < 0 ? -1 : 0;
    }
    if (winding == 0) {
      return 0;
    }
    const int height = side_of_plane(scene_.points, support[0], support[1], support[2], start_);
    const int slope = winding * direction_;
    return height * slope < 0 ? slope : 0;
  }

 private:
  // Of something that lies between the ends of extent(k) along each axis k.
  template <class Extent>
  [[nodiscard]] bool may_meet_extent(const Extent& extent) const {
    for (const int k : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const Interval x = scene_.points.interval(start_, k);
      const auto [low, high] = extent(k);
      if (x.sup() < low || x.inf() > high) {
        return false;
      }
    }
    const Interval x = scene_.points.interval(start_, axis_);
    const auto [low, high] = extent(axis_);
    return direction_ > 0 ? x.inf() <= high : x.sup() >= low;
  }

  const Scene& scene_;
  PointId start_;
  int axis_, direction_;
};

// How often the ray leaves the operand more than it enters it. The triangles that cover the start
// do not count.
int crossings(const Scene& scene, const Ray& ray, std::size_t operand,
              std::span<const SignedTriangle> cover) {
  const std::uint32_t first = scene.first_triangle[operand];
  const std::uint32_t count = scene.first_triangle[operand + 1] - first;
  std::vector<int> sums(block_count(count), 0);
  for_each_block(count, [&](const Block& block) {
    const UpwardRounding rounding;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto t = static_cast<std::uint32_t>(first + i);
      const auto is_t = [t](const SignedTriangle& s) { return s.triangle == t; };
      if (ray.may_meet(scene.triangles[t]) && std::none_of(cover.begin(), cover.end(), is_t)) {
        sums[block.number] += ray.crossing(scene.triangles[t], scene.support(t));
      }
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0);
}

}  // namespace

std::vector<int> counts_in_front(Scene& scene, const BooleanRule& rule, const Triangle& corners,
                                 const Triangle& support, std::span<const SignedTriangle> cover) {
  const PointId start = scene.points.add(middle(scene.points, corners));
  const Ray ray(scene, start, projection_of(scene.points, support));
  std::vector<int> counts(rule.groups, 0);
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    if (ray.may_meet(scene.bounds[o])) {
      counts[rule.group_of_operand[o]] += crossings(scene, ray, o, cover);
    }
  }
  scene.points.remove_last();
  return counts;
}

}  // namespace dupin::detail
