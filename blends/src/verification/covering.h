#pragma once

#include <vector>

#include "dupin/blends/certificate.h"

namespace dupin::verification {

/// Whether the rectangles of the leaves cover the rectangle, or its part where first <= second.
/// O(n log n).
[[nodiscard]] bool covered(const ParameterInterval& first, const ParameterInterval& second,
                           const std::vector<DiscPairs>& leaves, bool ordered);

}  // namespace dupin::verification
