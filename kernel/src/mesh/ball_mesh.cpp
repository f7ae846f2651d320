#include "mesh/ball_mesh.h"

#include <algorithm>
#include <cstdint>

#include "exact/vector_algebra.h"
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
  const std::uint32_t origin = mesh.triangles.front()[0];
  const auto from = [&](std::uint32_t start, std::uint32_t end) {
    return exact::difference(mesh.points[end], mesh.points[start]);
  };
  exact::Ball six;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a != origin && b != origin && c != origin) {
      six = six + exact::dot(from(origin, a), exact::cross(from(a, b), from(a, c)));
    }
  }
  return six.sign();
}

}  // namespace dupin::mesh
