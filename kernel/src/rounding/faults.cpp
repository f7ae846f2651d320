#include "rounding/faults.h"

#include <algorithm>
#include <array>

#include "checking/self_intersection.h"
#include "predicates/triangle_overlap.h"
#include "support/blocks.h"

namespace dupin::rounding {

bool is_degenerate(const Embedding& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return predicates::collinear(mesh.points[a], mesh.points[b], mesh.points[c]);
}

bool is_faulty_pair(const Embedding& mesh, std::uint32_t f, std::uint32_t g) {
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
  return foreign_contact || predicates::TriangleOverlapTest(corners, {0, 1, 2}).meeting(second) !=
                                predicates::TriangleOverlap::none;
}

support::BulkVector<std::uint8_t> marked_faces(std::span<const Triangle> triangles,
                                               std::span<const std::uint8_t> marked_points) {
  support::BulkVector<std::uint8_t> marked(triangles.size());
  support::for_each_block(marked.size(), [&](const support::Block& block) {
    for (std::size_t f = block.begin; f < block.end; ++f) {
      const auto& [a, b, c] = triangles[f];
      marked[f] = marked_points[a] | marked_points[b] | marked_points[c];
    }
  });
  return marked;
}

std::vector<Fault> find_faults(const Embedding& mesh, std::span<const std::uint8_t> marked) {
  const checking::SelfIntersections found = checking::find_self_intersections(
      mesh.points, mesh.triangles,
      {.active = marked, .same = mesh.twins, .closed = true, .classes = mesh.classes});
  std::vector<Fault> bad;
  for (const std::uint32_t face : found.degenerate) {
    bad.push_back({face, face});
  }
  for (const checking::FacePair& pair : found.pairs) {
    if (pair.kind != checking::FacePair::Kind::contact) {
      bad.push_back({pair.first, pair.second});
    }
  }
  return bad;
}

}  // namespace dupin::rounding
