#pragma once

#include <cstdint>
#include <vector>

#include "exact_mesh.h"
#include "repair_mesh.h"

namespace dupin::detail {

/// One face of each shell that lies inside out after rounding: whose volume has changed its sign.
/// `mesh` began as the triangles of `exact`; no point moved further than `largest_move`.
[[nodiscard]] std::vector<std::uint32_t> turned_shells(const ExactMesh& exact,
                                                       const RepairMesh& mesh, double largest_move);

/// Removes the shells of the given faces that lie within `reach` of one of their points. Returns
/// their number.
std::size_t remove_small_shells(RepairMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach);

}  // namespace dupin::detail
