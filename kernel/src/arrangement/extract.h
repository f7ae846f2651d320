#pragma once

#include <cstdint>
#include <vector>

#include "patches.h"
#include "umbrellas.h"

namespace dupin::detail {

/// Stage 7a: the triangles of the selected patches; those that nothing touched keep their order.
[[nodiscard]] BulkVector<Kept> collect(const Scene& scene, const Incidences& incidences,
                                       const Pieces& pieces, const Patches& patches,
                                       const std::vector<std::int8_t>& selection);

/// Stage 7b: the mesh they make. Points that doubles hold come first; every triangle names its
/// source.
[[nodiscard]] ExactMesh extract(Scene& scene, BulkVector<Kept> kept);

}  // namespace dupin::detail
