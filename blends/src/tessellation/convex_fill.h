#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::tessellation {

/// The convex polygon of the corners first..last, by halving: triangles as round as can be, and no
/// corner in more than O(log n) of them.
void fill(std::uint32_t first, std::uint32_t last, std::vector<Triangle>& triangles);

}  // namespace dupin::tessellation
