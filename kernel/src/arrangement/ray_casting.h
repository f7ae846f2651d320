#pragma once

#include <span>
#include <vector>

#include "arrangement/input.h"

namespace dupin::arrangement {

/// How often the operands of each group contain the places right in front of a piece: signed
/// crossings of a ray from its middle. `corners` span the piece, `support` gives its plane and
/// orientation, and `cover` the triangles it is part of. Adds a point to the scene and removes it.
/// O(triangles) in the worst case. Needs UpwardRounding.
[[nodiscard]] std::vector<int> winding_numbers_at(ArrangementInput& input, const BooleanRule& rule,
                                                  const Triangle& corners, const Triangle& support,
                                                  std::span<const SignedTriangle> cover);

}  // namespace dupin::arrangement
