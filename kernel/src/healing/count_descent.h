#pragma once

#include <span>
#include <vector>

#include "healing/patch_counts.h"
#include "mesh/edge_table.h"

namespace dupin::healing {

/// Changes counts of single triangles, each time such that less is missing at its edges; the
/// result may be open still. `edges` are those of different triangles, their corners ascending.
/// Mends what was copied or turned here and there in a surface whose counts are right else.
///
/// O(n): gives up after a number of steps in proportion to the triangles.
[[nodiscard]] std::vector<int> descended_counts(const mesh::EdgeTable& edges,
                                                std::span<const CountRange> ranges);

}  // namespace dupin::healing
