#include "bad_items.h"

#include <algorithm>
#include <array>

#include "arrangement/blocks.h"
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

BulkVector<std::uint8_t> marked_faces(std::span<const Triangle> triangles,
                                      std::span<const std::uint8_t> marked_points) {
  BulkVector<std::uint8_t> marked(triangles.size());
  for_each_block(marked.size(), [&](const Block& block) {
    for (std::size_t f = block.begin; f < block.end; ++f) {
      const auto& [a, b, c] = triangles[f];
      marked[f] = marked_points[a] | marked_points[b] | marked_points[c];
    }
  });
  return marked;
}

std::vector<BadItem> find_bad_items(const Embedding& mesh, std::span<const std::uint8_t> marked) {
  const SelfIntersections found = find_self_intersections(
      mesh.points, mesh.triangles,
      {.active = marked, .same = mesh.twins, .closed = true, .classes = mesh.classes});
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
