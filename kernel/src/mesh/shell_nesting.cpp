#include "mesh/shell_nesting.h"

#include <algorithm>

#include "exact/exact_numbers.h"
#include "mesh/ray_crossing.h"

namespace dupin::mesh {
namespace {

using CGAL::Mpzf;

exact::ExactVector tripled(const Vec3& point) {
  return {Mpzf(point.x()) * 3, Mpzf(point.y()) * 3, Mpzf(point.z()) * 3};
}

// A triangle and the start of a ray along +x, for ray_crossing().
struct TriangleAndStart {
  std::array<exact::ExactVector, 3> corners;
  const exact::ExactVector& start;

  [[nodiscard]] bool is_above(std::size_t i) const { return corners[i][2] > start[2]; }
  [[nodiscard]] int turn(std::size_t i, std::size_t j) const {
    const exact::ExactVector &a = corners[i], &b = corners[j];
    return exact::sign((b[1] - a[1]) * (start[2] - a[2]) - (b[2] - a[2]) * (start[1] - a[1]));
  }
  [[nodiscard]] int side() const {
    const exact::ExactVector normal =
        exact::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return exact::sign(exact::dot(normal, start - corners[0]));
  }
};

}  // namespace

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

Eigen::AlignedBox3d ShellNest::bounds_of(std::uint32_t face) const {
  Eigen::AlignedBox3d bounds;
  for (const std::uint32_t corner : mesh_.triangles[face]) {
    bounds.extend(mesh_.points[corner]);
  }
  return bounds;
}

// A small face makes few candidates for the ray.
std::uint32_t ShellNest::test_face(std::size_t shell) const {
  const auto spread = [&](std::uint32_t face) { return bounds_of(face).sizes().tail<2>().sum(); };
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
      point[i] = point[i] + Mpzf(mesh_.points[corner][i]);
    }
  }
  const Eigen::AlignedBox3d around = bounds_of(test_faces_[inner]);
  int winding = 0;
  for (const std::uint32_t face : shells_.faces_of(outer)) {
    const Eigen::AlignedBox3d bounds = bounds_of(face);
    if (bounds.max().x() < around.min().x() || bounds.min().y() > around.max().y() ||
        bounds.max().y() < around.min().y() || bounds.min().z() > around.max().z() ||
        bounds.max().z() < around.min().z()) {
      continue;
    }
    const Triangle& t = mesh_.triangles[face];
    const TriangleAndStart triangle{
        {tripled(mesh_.points[t[0]]), tripled(mesh_.points[t[1]]), tripled(mesh_.points[t[2]])},
        point};
    winding += ray_crossing(triangle, 1);
  }
  return winding != 0;
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
