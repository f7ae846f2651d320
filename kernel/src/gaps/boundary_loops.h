#pragma once

#include <vector>

#include "dupin/kernel/mesh_gap.h"

namespace dupin::gaps {

/// The chains of directed edges that no face runs along the other way, by lowest starting point.
/// Where several leave a point, the one to the lowest point comes first. Throws as `merged` does.
[[nodiscard]] std::vector<BoundaryLoop> boundary_loops(const TriMesh& mesh);

}  // namespace dupin::gaps
