#pragma once

#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::drawing {

/// The same lines, those put together of which two and no more end in one point, bitwise. In the
/// order of their first pieces. O(n log n).
[[nodiscard]] std::vector<std::vector<Vec3>> linked(std::vector<std::vector<Vec3>> lines);

}  // namespace dupin::drawing
