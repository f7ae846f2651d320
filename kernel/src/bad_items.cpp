#include "bad_items.h"

#include <algorithm>
#include <array>

#include "self_intersection.h"
#include "triangle_meeting.h"

namespace dupin::detail {

bool is_degenerate(const Embedding& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return collinear(mesh.points[a], mesh.points[b], mesh.points[c]);
}

bool is_bad_pair(const Embedding& mesh, std::uint32_t f, std::uint32_t g) {
  std::array<Vec3, 6> corners;
  Triangle second{};
  bool foreign_contact = false;
  for (std::uint32_t i = 0; i < 3; ++i) {
    corners[i] = mesh.points[mesh.triangles[f][i]];
    corners[3 + i] = mesh.points[mesh.triangles[g][i]];
    second[i] = 3 + i;
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      if (corners[i] == corners[3 + j]) {
        second[j] = i;
        foreign_contact =
            foreign_contact || mesh.twins[mesh.triangles[f][i]] != mesh.twins[mesh.triangles[g][j]];
      }
    }
  }
  return foreign_contact || TriangleProbe(corners, {0, 1, 2}).meeting(second) != Meeting::none;
}

std::vector<BadItem> find_bad_items(const Embedding& mesh,
                                    std::span<const std::uint8_t> marked_points) {
  std::vector<std::uint8_t> active(mesh.triangles.size());
  for (std::size_t f = 0; f < active.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    active[f] = marked_points[a] | marked_points[b] | marked_points[c];
  }
  const SelfIntersections found = find_self_intersections(
      mesh.points, mesh.triangles, {.active = active, .same = mesh.twins, .closed = true});
  std::vector<BadItem> bad;
  for (const std::uint32_t face : found.degenerate) {
    bad.push_back({face, face});
  }
  for (const FacePair& pair : found.pairs) {
    if (pair.kind != FacePair::Kind::contact) {
      bad.push_back({pair.first, pair.second});
    }
  }
  return bad;
}

}  // namespace dupin::detail
