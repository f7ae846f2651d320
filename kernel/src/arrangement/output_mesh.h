#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/manifold_patches.h"
#include "arrangement/non_manifold_vertices.h"

namespace dupin::arrangement {

/// Stage 8: the triangles of the selected patches; those that nothing touched keep their order.
[[nodiscard]] support::BulkVector<OutputTriangle> collect_output_triangles(
    const ArrangementInput& input, const Subdivision& subdivision, const ManifoldPatches& patches,
    const std::vector<std::int8_t>& selection);

/// And the mesh they make. Points that doubles hold come first; every triangle names its
/// source.
[[nodiscard]] mesh::ExactMesh extract(ArrangementInput& input,
                                      support::BulkVector<OutputTriangle> kept);

}  // namespace dupin::arrangement
