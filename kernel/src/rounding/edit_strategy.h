#pragma once

#include <vector>

#include "exact/float_lattice.h"
#include "rounding/edited_mesh.h"

namespace dupin::rounding {

/// Removes the known bad items one by one, in order, by collapsing an edge not longer than `reach`,
/// else flipping an edge, else moving a point to a near number of the lattice. Every step lowers
/// their number. Gives up once about as many edits have been tried as `trials` says; returns how
/// many are left, 0 if it gave up.
std::uint64_t repair(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach,
                     std::uint64_t trials);

/// Collapses edges shorter than `reach` and flips away triangles that are lower, among `faces` and
/// what these edits touch, where the mesh stays free of bad items. What is thinner than the
/// rounding's step is what rounding breaks.
void clean_up(EditedMesh& mesh, double reach, std::vector<std::uint32_t> faces);

/// `faces` and all that share a point with them, ascending.
[[nodiscard]] std::vector<std::uint32_t> with_neighbours(const EditedMesh& mesh,
                                                         const std::vector<std::uint32_t>& faces);

}  // namespace dupin::rounding
