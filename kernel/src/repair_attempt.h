#pragma once

#include <cstdint>
#include <vector>

#include "bad_items.h"
#include "lattice.h"
#include "mesh_part.h"
#include "repair_mesh.h"

namespace dupin::detail {

/// What an attempt at repair may do.
struct AttemptTerms {
  Lattice lattice;
  double largest;        ///< coordinate
  double reach;          ///< of collapses and moves
  std::uint64_t trials;  ///< edits to be tried
};

/// Around the faces that rounding breaks: repairs the mesh of doubles, then, for a coarser lattice,
/// thickens what is thin, rounds, and repairs again. `broken_pairs` are the bad items of the mesh
/// that is rounded only. Returns how many trials are left; bad items may be, too.
std::uint64_t attempt_repair(RepairMesh& mesh, const BrokenMesh& original,
                             const std::vector<std::uint32_t>& broken,
                             const std::vector<BadItem>& broken_pairs, const AttemptTerms& terms);

}  // namespace dupin::detail
