#pragma once

#include <vector>

#include "edge_table.h"
#include "mesh_view.h"

namespace dupin::detail {

/// For each shell the number of other shells around it, by exact ray tests. The shells are closed
/// surfaces of doubles that share no area and do not cross; they may touch. Shells with disjoint
/// boxes cost nothing.
[[nodiscard]] std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells);

}  // namespace dupin::detail
