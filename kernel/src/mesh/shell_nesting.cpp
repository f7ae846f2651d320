#include "mesh/shell_nesting.h"

#include <algorithm>

namespace dupin::mesh {

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
  if (!boxes_[outer].contains(boxes_[inner])) {
    return false;
  }
  return winding_number(mesh_, shells_.faces_of(outer), point_within(mesh_, test_faces_[inner])) !=
         0;
}

std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells) {
  std::vector<int> depths(shells.count);
  if (shells.count < 2) {
    return depths;
  }
  const ShellNest nest(mesh, shells);
  for (std::size_t inner = 0; inner < shells.count; ++inner) {
    for (std::size_t outer = 0; outer < shells.count; ++outer) {
      if (outer != inner && nest.encloses(outer, inner)) {
        ++depths[inner];
      }
    }
  }
  return depths;
}

}  // namespace dupin::mesh
