#include "mesh/point_winding.h"

#include <cmath>

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

// Whether a ray from the box passes the triangle: beyond one of its edges, seen along the ray. In
// plain numbers, with more room than their rounding takes; false where that is not enough.
bool passes(const std::array<Vec3, 3>& corners, const Eigen::AlignedBox3d& around) {
  constexpr double kRounding = 0x1p-46, kUnderflow = 1e-300;
  using Flat = Eigen::Vector2d;  // y and z
  const Flat low = around.min().tail<2>(), high = around.max().tail<2>();
  const auto doubled_area = [](const Flat& u, const Flat& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const auto without_sign = [](const Flat& u, const Flat& v) {
    return std::abs(u.x()) * v.y() + std::abs(u.y()) * v.x();
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Flat a = corners[i].tail<2>(), b = corners[(i + 1) % 3].tail<2>(),
               c = corners[(i + 2) % 3].tail<2>();
    const Flat edge = b - a;
    const double third = doubled_area(edge, c - a);
    const double start = doubled_area(edge, (low + high) / 2 - a);
    const double reach = without_sign(edge, (high - low) / 2);
    const Flat size = a.cwiseAbs() + c.cwiseAbs() + low.cwiseAbs() + high.cwiseAbs();
    const double error = kRounding * without_sign(edge, size) + kUnderflow;
    if ((third > error && start + reach < -error) || (third < -error && start - reach > error)) {
      return true;
    }
  }
  return false;
}

std::array<Vec3, 3> corners(const MeshView& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

std::array<exact::ExactVector, 3> times(const std::array<Vec3, 3>& points, int scale) {
  return {times(points[0], scale), times(points[1], scale), times(points[2], scale)};
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
    const std::array<Vec3, 3> triangle = corners(mesh, face);
    if (!passes(triangle, point.around)) {
      winding += ray_crossing(TriangleAndStart{times(triangle, point.scale), point.scaled}, 1);
    }
  }
  return winding;
}

bool may_touch(const MeshView& mesh, std::uint32_t face, const Vec3& point) {
  const exact::ExactVector start = exact::exact_vector(point);
  return bounds_of(mesh, face).contains(point) &&
         TriangleAndStart{times(corners(mesh, face), 1), start}.side() == 0;
}

}  // namespace dupin::mesh
