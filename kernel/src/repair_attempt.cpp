#include "repair_attempt.h"

#include <utility>

#include "arrangement/blocks.h"
#include "arrangement/bulk_vector.h"
#include "mesh_repair.h"

namespace dupin::detail {
namespace {

/// The corners of faces that are not where the solid has them.
std::vector<std::uint8_t> inexact_points(const RepairMesh& mesh, const BrokenMesh& original,
                                         const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint8_t> inexact(mesh.points().size(), 0);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : mesh.triangle(f)) {
      inexact[v] = original.inexact[v];
    }
  }
  return inexact;
}

/// The corners of faces that are not as in the mesh that is rounded only.
std::vector<std::uint8_t> differing_points(const RepairMesh& mesh, const BrokenMesh& original) {
  std::vector<std::uint8_t> differing(mesh.points().size(), 0);
  for (std::uint32_t v = 0; v < differing.size(); ++v) {
    differing[v] = mesh.point(v) != original.on_lattice[v] ? 1 : 0;
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.alive(f) && mesh.triangle(f) != original.triangles[f]) {
      for (const std::uint32_t v : mesh.triangle(f)) {
        differing[v] = 1;
      }
    }
  }
  return differing;
}

/// Rounds the mesh: points that are where they were as the original has them.
void place_on_lattice(RepairMesh& mesh, const BrokenMesh& original, const Lattice& lattice) {
  BulkVector<Vec3> points(mesh.points().size());
  for_each_block(points.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3& here = mesh.points()[i];
      points[i] = here == original.doubles[i] ? original.on_lattice[i] : lattice.nearest(here);
    }
  });
  mesh.place(std::move(points));
}

}  // namespace

std::uint64_t attempt_repair(RepairMesh& mesh, const BrokenMesh& original,
                             const std::vector<std::uint32_t>& broken,
                             const std::vector<BadItem>& broken_pairs, const AttemptTerms& terms) {
  const auto& [lattice, largest, reach, trials] = terms;
  std::uint64_t left = trials;
  if (!lattice.holds_doubles()) {
    const Lattice doubles(Coordinates::binary64);
    const auto around = with_neighbours(mesh, with_neighbours(mesh, broken));
    mesh.find_bad_items(inexact_points(mesh, original, around));
    left = repair(mesh, doubles, reach / lattice.step(largest) * doubles.step(largest), left);
    clean_up(mesh, reach, with_neighbours(mesh, broken));
    place_on_lattice(mesh, original, lattice);
  }
  mesh.find_bad_items(differing_points(mesh, original), broken_pairs);
  return repair(mesh, lattice, reach, left);
}

}  // namespace dupin::detail
