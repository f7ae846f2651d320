#include "candidates.h"

#include <algorithm>

#include <CGAL/box_intersection_d.h>

namespace dupin::detail {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

std::vector<Box> boxes_within(const Scene& scene, std::uint32_t operand,
                              const Scene::Bounds& window) {
  std::vector<Box> boxes;
  const ExactMesh& mesh = *scene.operands[operand];
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t t = scene.first_triangle[operand] + i;
    Scene::Bounds box;
    for (const std::uint32_t corner : mesh.triangles[i]) {
      box.extend(mesh.points[corner]);
    }
    if (!scene.merged[t] && box.intersects(window)) {
      boxes.emplace_back(CGAL::Bbox_3(box.min()[0], box.min()[1], box.min()[2], box.max()[0],
                                      box.max()[1], box.max()[2]),
                         t);
    }
  }
  return boxes;
}

}  // namespace

std::vector<TrianglePair> find_candidates(const Scene& scene) {
  std::vector<TrianglePair> pairs;
  for (const auto& [a, b] : scene.operand_pairs) {
    const Scene::Bounds window = scene.bounds[a].intersection(scene.bounds[b]);
    std::vector<Box> first = boxes_within(scene, a, window),
                     second = boxes_within(scene, b, window);
    const std::size_t before = pairs.size();
    CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(),
                             [&pairs](const Box& x, const Box& y) {
                               pairs.push_back({x.info(), y.info()});
                             });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
  }
  return pairs;
}

}  // namespace dupin::detail
