#include "rounding/edit_attempt.h"

#include <algorithm>

#include "rounding/edit_strategy.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {
namespace {

/// The faces with corners, of the faces given, that are not where the solid has them.
support::BulkVector<std::uint8_t> inexact_faces(const EditedMesh& mesh, const BrokenMesh& original,
                                                const std::vector<std::uint32_t>& faces) {
  support::BulkVector<std::uint8_t> inexact(mesh.face_count(), 0);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : mesh.triangle(f)) {
      for (const std::uint32_t face : mesh.faces(v)) {
        inexact[face] |= original.inexact[v];
      }
    }
  }
  return inexact;
}

/// The faces that are not as in the mesh that is rounded only.
support::BulkVector<std::uint8_t> differing_faces(const EditedMesh& mesh,
                                                  const BrokenMesh& original) {
  support::BulkVector<std::uint8_t> differing(mesh.face_count());
  support::for_each_block(differing.size(), [&](const support::Block& block) {
    for (auto f = static_cast<std::uint32_t>(block.begin); f < block.end; ++f) {
      const Triangle& t = mesh.triangle(f);
      const bool has_moved = std::ranges::any_of(
          t, [&](std::uint32_t v) { return mesh.point(v) != original.on_lattice[v]; });
      differing[f] = mesh.alive(f) && (has_moved || t != original.triangles[f]) ? 1 : 0;
    }
  });
  return differing;
}

/// Rounds the mesh: points that are where they were as the original has them.
void place_on_lattice(EditedMesh& mesh, const BrokenMesh& original,
                      const exact::FloatLattice& lattice) {
  support::BulkVector<Vec3> points(mesh.points().size());
  support::for_each_block(points.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3& here = mesh.points()[i];
      points[i] = here == original.doubles[i] ? original.on_lattice[i] : lattice.nearest(here);
    }
  });
  mesh.place(std::move(points));
}

}  // namespace

std::uint64_t repair_around(EditedMesh& mesh, const BrokenMesh& original,
                            const std::vector<std::uint32_t>& broken,
                            const std::vector<Fault>& broken_pairs, const RepairLimits& terms) {
  const auto& [lattice, largest, reach, trials] = terms;
  std::uint64_t left = trials;
  if (!lattice.holds_doubles()) {
    const exact::FloatLattice doubles(Coordinates::binary64);
    const auto around = with_neighbours(mesh, broken);
    mesh.find_faults(inexact_faces(mesh, original, around));
    left = repair(mesh, doubles, reach / lattice.step(largest) * doubles.step(largest), left);
    clean_up(mesh, reach, with_neighbours(mesh, broken));
    place_on_lattice(mesh, original, lattice);
  }
  mesh.find_faults(differing_faces(mesh, original), broken_pairs);
  return repair(mesh, lattice, reach, left);
}

}  // namespace dupin::rounding
