#pragma once

#include <span>
#include <vector>

#include "scene.h"

namespace dupin::detail {

/// How often the operands of each group contain the places right in front of a piece: signed
/// crossings of a ray from its middle. `corners` span the piece, `support` gives its plane and
/// orientation, and `cover` the triangles it is part of. Adds a point to the scene and removes it.
/// O(triangles) in the worst case. Needs UpwardRounding.
[[nodiscard]] std::vector<int> counts_in_front(Scene& scene, const BooleanRule& rule,
                                               const Triangle& corners, const Triangle& support,
                                               std::span<const SignedTriangle> cover);

}  // namespace dupin::detail
