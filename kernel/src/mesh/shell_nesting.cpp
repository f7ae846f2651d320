#include "mesh/shell_nesting.h"

#include <algorithm>
#include <optional>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"

namespace dupin::mesh {
namespace {

std::vector<boxes::Box> framed(std::span<const Eigen::AlignedBox3d> all,
                               const boxes::BoxQuantizer& quantizer) {
  std::vector<boxes::Box> result;
  result.reserve(all.size());
  for (const Eigen::AlignedBox3d& box : all) {
    const auto low = quantizer.map(box.min()), high = quantizer.map(box.max());
    result.push_back(quantizer.around({low, high, high}));
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
    : mesh_(mesh), shells_(shells), boxes_(shells.count), test_faces_(shells.count) {
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    for (const std::uint32_t face : shells.faces_of(shell)) {
      for (const std::uint32_t corner : mesh.triangles[face]) {
        boxes_[shell].extend(mesh.points[corner]);
      }
    }
    test_faces_[shell] = test_face(shell);
  }
}

std::uint32_t ShellNest::test_face(std::size_t shell) const {
  return *std::ranges::min_element(shells_.faces_of(shell), {},
                                   [&](std::uint32_t face) { return ray_cost(mesh_, face); });
}

bool ShellNest::encloses(std::size_t outer, std::size_t inner) const {
  return boxes_[outer].contains(boxes_[inner]) && encloses(outer, test_point(inner));
}

bool ShellNest::encloses(std::size_t outer, const WindingPoint& point) const {
  return winding_number(mesh_, shells_.faces_of(outer), point) != 0;
}

WindingPoint ShellNest::test_point(std::size_t shell) const {
  return point_within(mesh_, test_faces_[shell]);
}

std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells) {
  std::vector<int> depths(shells.count);
  if (shells.count < 2) {
    return depths;
  }
  const ShellNest nest(mesh, shells);
  std::vector<Vec3> corners;
  corners.reserve(2 * shells.count);
  for (const Eigen::AlignedBox3d& box : nest.boxes()) {
    corners.insert(corners.end(), {box.min(), box.max()});
  }
  const boxes::BoxQuantizer quantizer(corners);
  const boxes::BoxTree tree(framed(nest.boxes(), quantizer));
  for (std::size_t inner = 0; inner < shells.count; ++inner) {
    const Eigen::AlignedBox3d& box = nest.boxes()[inner];
    const auto corner = quantizer.map(box.min());
    std::optional<WindingPoint> point;
    tree.visit(quantizer.around({corner, corner, corner}), [&](std::uint32_t outer) {
      if (outer == inner || !nest.boxes()[outer].contains(box)) {
        return;
      }
      if (!point) {
        point = nest.test_point(inner);
      }
      depths[inner] += nest.encloses(outer, *point) ? 1 : 0;
    });
  }
  return depths;
}

}  // namespace dupin::mesh
