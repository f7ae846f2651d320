#pragma once

#include <cstdint>
#include <vector>

#include "patches.h"

namespace dupin::detail {

/// Stage 6b: what becomes of each patch: 0 dropped, +1 kept, -1 kept with its sides exchanged.
///
/// Counts pass from patch to patch around the seams; a ray settles each set of patches that no
/// seam connects to another. Needs UpwardRounding.
[[nodiscard]] std::vector<std::int8_t> select(Scene& scene, const BooleanRule& rule,
                                              const Incidences& incidences, const Pieces& pieces,
                                              const Patches& patches);

}  // namespace dupin::detail
