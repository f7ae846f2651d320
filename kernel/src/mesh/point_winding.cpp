#include "mesh/point_winding.h"

#include "mesh/ray_crossing.h"

namespace dupin::mesh {
namespace {

using CGAL::Mpzf;

exact::ExactVector times(const Vec3& point, int scale) {
  return {Mpzf(point.x()) * scale, Mpzf(point.y()) * scale, Mpzf(point.z()) * scale};
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

std::array<exact::ExactVector, 3> corners(const MeshView& mesh, std::uint32_t face, int scale) {
  const Triangle& t = mesh.triangles[face];
  return {times(mesh.points[t[0]], scale), times(mesh.points[t[1]], scale),
          times(mesh.points[t[2]], scale)};
}

}  // namespace

Eigen::AlignedBox3d bounds_of(const MeshView& mesh, std::uint32_t face) {
  Eigen::AlignedBox3d bounds;
  for (const std::uint32_t corner : mesh.triangles[face]) {
    bounds.extend(mesh.points[corner]);
  }
  return bounds;
}

int winding_number(const MeshView& mesh, std::span<const std::uint32_t> faces,
                   const WindingPoint& point) {
  const Vec3 &low = point.around.min(), &high = point.around.max();
  int winding = 0;
  for (const std::uint32_t face : faces) {
    const Eigen::AlignedBox3d bounds = bounds_of(mesh, face);
    if (bounds.max().x() < low.x() || bounds.min().y() > high.y() || bounds.max().y() < low.y() ||
        bounds.min().z() > high.z() || bounds.max().z() < low.z()) {
      continue;
    }
    const TriangleAndStart triangle{corners(mesh, face, point.scale), point.scaled};
    winding += ray_crossing(triangle, 1);
  }
  return winding;
}

bool may_touch(const MeshView& mesh, std::uint32_t face, const Vec3& point) {
  const exact::ExactVector start = exact::exact_vector(point);
  return bounds_of(mesh, face).contains(point) &&
         TriangleAndStart{corners(mesh, face, 1), start}.side() == 0;
}

}  // namespace dupin::mesh
