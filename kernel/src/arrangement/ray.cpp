#include "ray.h"

#include <algorithm>

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
    for (const int k : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const Interval x = scene_.points.interval(start_, k);
      if (x.sup() < box.min()[k] || x.inf() > box.max()[k]) {
        return false;
      }
    }
    const Interval x = scene_.points.interval(start_, axis_);
    return direction_ > 0 ? x.inf() <= box.max()[axis_] : x.sup() >= box.min()[axis_];
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
  const Scene& scene_;
  PointId start_;
  int axis_, direction_;
};

Scene::Bounds bounds_of(const PointTable& points, const Triangle& corners) {
  Scene::Bounds box;
  for (const PointId id : corners) {
    const IntervalPoint p = points.interval(id);
    box.extend(Vec3(p[0].inf(), p[1].inf(), p[2].inf()));
    box.extend(Vec3(p[0].sup(), p[1].sup(), p[2].sup()));
  }
  return box;
}

}  // namespace

std::vector<int> counts_in_front(Scene& scene, const BooleanRule& rule, const Triangle& corners,
                                 const Triangle& support, std::span<const SignedTriangle> cover) {
  const PointId start = scene.points.add(middle(scene.points, corners));
  const Ray ray(scene, start, projection_of(scene.points, support));
  std::vector<int> counts(rule.groups, 0);
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    if (!ray.may_meet(scene.bounds[o])) {
      continue;
    }
    int& count = counts[rule.group_of_operand[o]];
    for (std::uint32_t t = scene.first_triangle[o]; t < scene.first_triangle[o + 1]; ++t) {
      const auto is_t = [t](const SignedTriangle& s) { return s.triangle == t; };
      if (ray.may_meet(bounds_of(scene.points, scene.triangles[t])) &&
          std::none_of(cover.begin(), cover.end(), is_t)) {
        count += ray.crossing(scene.triangles[t], scene.support(t));
      }
    }
  }
  scene.points.remove_last();
  return counts;
}

}  // namespace dupin::detail
