#include "mesh/shell_nesting.h"

#include <algorithm>
#include <optional>

namespace dupin::mesh {
namespace {

std::vector<Eigen::AlignedBox3d> boxes_of(const MeshView& mesh, const Shells& shells) {
  std::vector<Eigen::AlignedBox3d> result(shells.count);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const std::uint32_t corner : mesh.triangles[face]) {
      result[shells.of_face[face]].extend(mesh.points[corner]);
    }
  }
  return result;
}

boxes::BoxQuantizer quantizer_of(std::span<const Eigen::AlignedBox3d> all) {
  std::vector<Vec3> corners;
  corners.reserve(2 * all.size());
  for (const Eigen::AlignedBox3d& box : all) {
    corners.insert(corners.end(), {box.min(), box.max()});
  }
  return boxes::BoxQuantizer(corners);
}

std::vector<boxes::Box> framed(std::span<const Eigen::AlignedBox3d> all,
                               const boxes::BoxQuantizer& quantizer) {
  std::vector<boxes::Box> result;
  result.reserve(all.size());
  for (const Eigen::AlignedBox3d& box : all) {
    result.push_back(quantizer.around(box));
  }
  return result;
}

}  // namespace

double ray_cost(const MeshView& mesh, std::uint32_t face) {
  return bounds_of(mesh, face).sizes().tail<2>().sum();
}

// Three times it, and all is scaled by 3, to stay in integers.
WindingPoint point_within(const MeshView& mesh, std::uint32_t face) {
  exact::ExactVector point;
  for (const std::uint32_t corner : mesh.triangles[face]) {
    for (int i = 0; i < 3; ++i) {
      point[i] = point[i] + CGAL::Mpzf(mesh.points[corner][i]);
    }
  }
  return {point, 3, bounds_of(mesh, face)};
}

ShellNest::ShellNest(const MeshView& mesh, const Shells& shells)
    : mesh_(mesh),
      shells_(shells),
      boxes_(boxes_of(mesh, shells)),
      quantizer_(quantizer_of(boxes_)),
      tree_(framed(boxes_, quantizer_)) {}

bool ShellNest::encloses(std::size_t outer, std::size_t inner) const {
  return boxes_[outer].contains(boxes_[inner]) && encloses(outer, test_point(inner));
}

bool ShellNest::encloses(std::size_t outer, const WindingPoint& point) const {
  return winding_number(mesh_, shells_.faces_of(outer), point) != 0;
}

WindingPoint ShellNest::test_point(std::size_t shell) const {
  return point_within(
      mesh_, *std::ranges::min_element(shells_.faces_of(shell), {},
                                       [&](std::uint32_t face) { return ray_cost(mesh_, face); }));
}

void ShellNest::visit_boxes_around(std::size_t shell, double margin,
                                   const std::function<void(std::size_t)>& visit) const {
  const Vec3 &low = boxes_[shell].min(), &high = boxes_[shell].max();
  const auto corner = quantizer_.map(low);
  tree_.visit(quantizer_.around({corner, corner, corner}, margin), [&](std::uint32_t outer) {
    const Eigen::AlignedBox3d& box = boxes_[outer];
    if (outer != shell && (box.min() - low).maxCoeff() <= margin &&
        (high - box.max()).maxCoeff() <= margin) {
      visit(outer);
    }
  });
}

int ShellNest::depth(std::size_t shell) const {
  int depth = 0;
  std::optional<WindingPoint> point;
  visit_boxes_around(shell, 0, [&](std::size_t outer) {
    if (!point) {
      point = test_point(shell);
    }
    depth += encloses(outer, *point) ? 1 : 0;
  });
  return depth;
}

std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells) {
  std::vector<int> depths(shells.count);
  if (shells.count < 2) {
    return depths;
  }
  const ShellNest nest(mesh, shells);
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    depths[shell] = nest.depth(shell);
  }
  return depths;
}

}  // namespace dupin::mesh
