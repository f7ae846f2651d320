#include "mesh/shell_nesting.h"

#include <algorithm>

#include "mesh/point_winding.h"

namespace dupin::mesh {

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

// A small face makes few candidates for the ray.
std::uint32_t ShellNest::test_face(std::size_t shell) const {
  const auto spread = [&](std::uint32_t face) {
    return bounds_of(mesh_, face).sizes().tail<2>().sum();
  };
  const auto faces = shells_.faces_of(shell);
  return *std::min_element(faces.begin(), faces.end(),
                           [&](std::uint32_t a, std::uint32_t b) { return spread(a) < spread(b); });
}

bool ShellNest::encloses(std::size_t outer, std::size_t inner) const {
  if (!boxes_[outer].contains(boxes_[inner])) {
    return false;
  }
  // Three times the centre of gravity of a triangle: a point that lies on no other shell, as shells
  // touch in vertices and edges only. All is scaled by 3 to stay in integers.
  exact::ExactVector point;
  for (const std::uint32_t corner : mesh_.triangles[test_faces_[inner]]) {
    for (int i = 0; i < 3; ++i) {
      point[i] = point[i] + CGAL::Mpzf(mesh_.points[corner][i]);
    }
  }
  return winding_number(mesh_, shells_.faces_of(outer),
                        {point, 3, bounds_of(mesh_, test_faces_[inner])}) != 0;
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
