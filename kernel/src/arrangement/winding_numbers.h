#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/manifold_patches.h"

namespace dupin::arrangement {

/// Stage 7: what becomes of each patch: 0 dropped, +1 kept, -1 kept with its sides exchanged.
///
/// Counts pass from patch to patch around the seams; a ray settles each set of patches that no
/// seam connects to another. Needs UpwardRounding.
[[nodiscard]] std::vector<std::int8_t> propagate_winding_numbers(ArrangementInput& input,
                                                                 const BooleanRule& rule,
                                                                 const Subdivision& subdivision,
                                                                 const ManifoldPatches& patches);

}  // namespace dupin::arrangement
