#include "mesh/ball_mesh.h"

#include <algorithm>
#include <cstdint>

#include "support/sequences.h"

namespace dupin::mesh {

BallMesh::BallMesh(const MeshView& mesh, std::span<const Triangle> of_mesh) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * of_mesh.size());
  for (const Triangle& triangle : of_mesh) {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  support::sort_unique(used);
  const auto number = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(used, point) - used.begin());
  };
  triangles.reserve(of_mesh.size());
  for (const auto& [a, b, c] : of_mesh) {
    triangles.push_back({number(a), number(b), number(c)});
  }
  points.reserve(used.size());
  for (const std::uint32_t point : used) {
    points.push_back(mesh.ball(point));
  }
}

int volume_sign(const BallMesh& mesh) {
  if (mesh.triangles.empty()) {
    return 0;
  }
  const auto difference = [&](std::uint32_t to, std::uint32_t from) -> exact::BallPoint {
    const exact::BallPoint &p = mesh.points[to], &q = mesh.points[from];
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  };
  const std::uint32_t origin = mesh.triangles.front()[0];
  exact::Ball six;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a != origin && b != origin && c != origin) {
      const exact::BallPoint p = difference(a, origin), u = difference(b, a), v = difference(c, a);
      six = six + p[0] * (u[1] * v[2] - u[2] * v[1]) + p[1] * (u[2] * v[0] - u[0] * v[2]) +
            p[2] * (u[0] * v[1] - u[1] * v[0]);
    }
  }
  return six.sign();
}

}  // namespace dupin::mesh
