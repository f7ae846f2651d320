#pragma once

#include <cstdint>
#include <vector>

#include "patches.h"

namespace dupin::detail {

/// Stage 7: the mesh of the selected patches. Points that doubles hold come first; triangles that
/// nothing touched keep their order; every triangle names its source.
[[nodiscard]] ExactMesh extract(Scene& scene, const Incidences& incidences, const Pieces& pieces,
                                const Patches& patches, const std::vector<std::int8_t>& selection);

}  // namespace dupin::detail
