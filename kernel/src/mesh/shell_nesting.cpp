#include "mesh/shell_nesting.h"

#include <algorithm>

#include "exact/exact_numbers.h"

namespace dupin::mesh {
namespace {

using CGAL::Mpzf;

exact::ExactVector tripled(const Vec3& point) {
  return {Mpzf(point.x()) * 3, Mpzf(point.y()) * 3, Mpzf(point.z()) * 3};
}

// The ray runs from q along +x. So that it passes through no edge, q is thought moved by
// (0, e, e^2) for an infinitely small e > 0; y points right and z upwards in what follows.
bool is_above(const exact::ExactVector& point, const exact::ExactVector& q) {
  return point[2] > q[2];
}

// Whether q is left of the line from a upwards to b. A q on the line has moved to its right.
bool is_left_of(const exact::ExactVector& q, const exact::ExactVector& a,
                const exact::ExactVector& b) {
  return exact::sign((b[1] - a[1]) * (q[2] - a[2]) - (b[2] - a[2]) * (q[1] - a[1])) > 0;
}

bool is_hit(const exact::ExactVector& q, const std::array<exact::ExactVector, 3>& corners) {
  int crossed = 0;  // edges to the right of q
  for (std::size_t i = 0; i < 3; ++i) {
    const exact::ExactVector &a = corners[i], &b = corners[(i + 1) % 3];
    if (is_above(a, q) != is_above(b, q)) {
      const bool upward = is_above(b, q);
      crossed += is_left_of(q, upward ? a : b, upward ? b : a) ? 1 : 0;
    }
  }
  if (crossed != 1) {
    return false;
  }
  const exact::ExactVector normal = exact::cross(corners[1] - corners[0], corners[2] - corners[0]);
  // q + t e_x is in the plane for t = -normal . (q - a) / normal_x.
  return exact::sign(exact::dot(normal, q - corners[0])) * exact::sign(normal[0]) < 0;
}

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
  bool inside = false;
  for (const std::uint32_t face : shells_.faces_of(outer)) {
    const Eigen::AlignedBox3d bounds = bounds_of(face);
    if (bounds.max().x() < around.min().x() || bounds.min().y() > around.max().y() ||
        bounds.max().y() < around.min().y() || bounds.min().z() > around.max().z() ||
        bounds.max().z() < around.min().z()) {
      continue;
    }
    const Triangle& t = mesh_.triangles[face];
    inside ^= is_hit(point, {tripled(mesh_.points[t[0]]), tripled(mesh_.points[t[1]]),
                             tripled(mesh_.points[t[2]])});
  }
  return inside;
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
