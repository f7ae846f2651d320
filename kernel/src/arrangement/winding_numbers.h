#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/manifold_patches.h"

namespace dupin::arrangement {

/// What becomes of each patch.
struct Selection {
  std::vector<std::int8_t> kept;     ///< 0 dropped, +1 kept, -1 kept with its sides exchanged
  std::vector<std::int8_t> outside;  ///< 1 of those that have the inside on neither side
};

/// Stage 7.
///
/// Counts pass from patch to patch around the seams; a ray settles each set of patches that no
/// seam connects to another. Needs UpwardRounding.
[[nodiscard]] Selection propagate_winding_numbers(ArrangementInput& input, const BooleanRule& rule,
                                                  const Subdivision& subdivision,
                                                  const ManifoldPatches& patches);

}  // namespace dupin::arrangement
