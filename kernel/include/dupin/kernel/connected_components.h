#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// For each point below `point_count` the lowest one that triangles connect it to: itself if there
/// is none lower. The triangles' indices are below `point_count`. All but O(n).
[[nodiscard]] std::vector<std::uint32_t> connected_components(std::span<const Triangle> triangles,
                                                              std::size_t point_count);

}  // namespace dupin
