#include "checking/disjoint_face_groups.h"

#include <algorithm>

#include "checking/height_field_patches.h"
#include "checking/injective_stars.h"
#include "support/blocks.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::checking {
namespace {

constexpr std::uint32_t kLarge = 64;

/// Whether triangles are to be grouped by stars. Not where points are identical: contacts are to be
/// told from neighbours.
bool has_large_stars(const WeldedMesh& mesh, const DisjointFaceGroups& groups) {
  return !mesh.has_identical_points() &&
         std::ranges::any_of(groups.injective_stars, [](std::uint32_t n) { return n >= kLarge; });
}

/// Makes groups, numbered from `count` on, of the triangles, among those given, around points that
/// have many.
void group_large_stars(const WeldedMesh& mesh, std::span<const std::uint32_t> faces,
                       std::uint32_t count, DisjointFaceGroups& groups) {
  const std::vector<std::uint32_t>& stars = groups.injective_stars;
  std::vector<std::uint32_t> number(mesh.points.size(), support::kNone);
  for (const std::uint32_t f : faces) {
    const Triangle& t = mesh.triangles[f];
    const auto largest = std::ranges::max(t, {}, [&](std::uint32_t v) { return stars[v]; });
    if (stars[largest] >= kLarge) {
      number[largest] = number[largest] == support::kNone ? count++ : number[largest];
      groups.of_face[f] = number[largest];
    }
  }
}

}  // namespace

DisjointFaceGroups proven_groups(const WeldedMesh& mesh, bool closed, double margin,
                                 std::span<const std::uint8_t> rim) {
  constexpr double kSmooth = 0.8;  // tees and chains have 0.9, headers and racks up to 0.7
  HeightFieldPatches patches =
      height_field_patches(mesh.points, mesh.triangles,
                           {.closed = closed, .rim = rim, .smooth = kSmooth, .margin = margin});
  for (std::uint32_t v = 0; v < mesh.points.size() && mesh.has_identical_points(); ++v) {
    if (mesh.representatives[v] != v) {
      patches.is_inner[mesh.representatives[v]] = 0;
    }
  }
  DisjointFaceGroups groups{std::move(patches.of_triangle),
                            injective_stars(mesh.points, mesh.corners, patches.is_inner, margin)};
  if (has_large_stars(mesh, groups)) {
    group_large_stars(mesh, support::numbers_below(mesh.triangles.size()), patches.count, groups);
  }
  return groups;
}

DisjointFaceGroups given_groups(const WeldedMesh& mesh, std::span<const std::uint32_t> given) {
  std::vector<std::uint8_t> marked(mesh.points.size(), 1);  // all but corners without a group
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < given.size(); ++f) {
    if (given[f] != support::kNone) {
      count = std::max(count, given[f] + 1);
      continue;
    }
    for (const std::uint32_t v : mesh.corners[f]) {
      marked[v] = 0;
    }
  }
  const auto around = support::indices_where(given.size(), [&](std::uint32_t f) {
    const auto& [a, b, c] = mesh.corners[f];
    return (marked[a] & marked[b] & marked[c]) == 0;
  });
  const auto corners = support::selected(mesh.corners, around);
  DisjointFaceGroups groups{{given.begin(), given.end()},
                            injective_stars(mesh.points, corners, marked)};
  if (has_large_stars(mesh, groups)) {
    group_large_stars(mesh, around, count, groups);
  }
  return groups;
}

}  // namespace dupin::checking
