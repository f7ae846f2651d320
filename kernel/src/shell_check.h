#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact_mesh.h"
#include "repair_mesh.h"

namespace dupin::detail {

/// One face of each shell that lies inside out after rounding: whose volume has changed its sign.
/// `mesh` began as the triangles of `exact`; no point moved further than `largest_move`.
[[nodiscard]] std::vector<std::uint32_t> turned_shells(const ExactMesh& exact,
                                                       const RepairMesh& mesh, double largest_move);

/// The faces at edges where the mesh touches itself and where rounding has made one sheet pass
/// through another, so that the faces around do not bound inside and outside in turn. `twins` is as
/// for the mesh.
[[nodiscard]] std::vector<std::uint32_t> crossed_contacts(const RepairMesh& mesh,
                                                          std::span<const std::uint32_t> twins);

/// Removes the shells of the given faces that lie within `reach` of one of their points. Returns
/// their number.
std::size_t remove_small_shells(RepairMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach);

}  // namespace dupin::detail
