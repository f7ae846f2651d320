#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/float_lattice.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/edits/mesh_part.h"

namespace dupin::rounding {

/// What an attempt at repair may do.
struct RepairLimits {
  exact::FloatLattice lattice;
  double step;   ///< of the lattice, at the largest coordinate
  double reach;  ///< of collapses and moves
  /// Whether to go to any length: there is no other way. Else points are moved only as long as
  /// that is worth it.
  bool is_thorough;
};

/// Thickens the mesh of doubles where it is free of faults, and then mends it, for which points may
/// move by `mending` more. `inexact`: a mark per point whose exact place is not the double. False
/// if faults are left.
bool thicken_doubles(EditedMesh& mesh, const BrokenMesh& original,
                     std::span<const std::uint8_t> inexact, double reach, double mending);

/// Around the faces that rounding breaks: for a lattice coarser than doubles thickens what is
/// thinner than a step; rounds, and mends. `broken_pairs` are the faults of the mesh that is
/// rounded only. Faults may be left; false if trying more was not worth it.
bool repair_around(EditedMesh& mesh, const BrokenMesh& original,
                   const std::vector<std::uint32_t>& broken, const std::vector<Fault>& broken_pairs,
                   const RepairLimits& limits);

/// Goes on where repair_around() left faults, with a larger reach, near the `broken` faces only.
bool repair_further(EditedMesh& mesh, const std::vector<std::uint32_t>& broken,
                    const RepairLimits& limits);

/// About how many edits are tried, and how many of them move points in vain.
struct MostTrials {
  std::uint64_t all, moves;
};

/// Removes the known faults one by one, in order, by collapsing an edge not longer than `reach`,
/// else flipping an edge, else moving a point to a neighbouring number of the lattice, else
/// collapsing or flipping an edge near by, else moving a point further. Every step lowers their
/// number. What takes more tries is tried where less does not help any fault, and nothing again
/// where nothing has changed. Gives up where that takes too many trials; whether it came to an end
/// before.
bool mend_faults(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach,
                 const MostTrials& most);

/// Collapses edges shorter than `reach` and flips away triangles that are lower, among `faces` and
/// what these edits touch, where the mesh stays free of faults. What is thinner than the rounding's
/// step is what rounding breaks.
void thicken(EditedMesh& mesh, double reach, std::vector<std::uint32_t> faces);

/// `faces` and all that share a point with them, ascending.
[[nodiscard]] std::vector<std::uint32_t> with_neighbours(const EditedMesh& mesh,
                                                         const std::vector<std::uint32_t>& faces);

}  // namespace dupin::rounding
