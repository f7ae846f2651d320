#pragma once

#include <cstdint>
#include <vector>

#include "exact/float_lattice.h"
#include "rounding/edited_mesh.h"
#include "rounding/faults.h"
#include "rounding/mesh_part.h"

namespace dupin::rounding {

/// What an attempt at repair may do.
struct RepairLimits {
  exact::FloatLattice lattice;
  double largest;        ///< coordinate
  double reach;          ///< of collapses and moves
  std::uint64_t trials;  ///< edits to be tried
};

/// Around the faces that rounding breaks: repairs the mesh of doubles, then, for a coarser lattice,
/// thickens what is thin, rounds, and repairs again. `broken_pairs` are the bad items of the mesh
/// that is rounded only. Returns how many trials are left; bad items may be, too.
std::uint64_t repair_around(EditedMesh& mesh, const BrokenMesh& original,
                            const std::vector<std::uint32_t>& broken,
                            const std::vector<Fault>& broken_pairs, const RepairLimits& terms);

}  // namespace dupin::rounding
