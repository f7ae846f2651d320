#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::checking {

/// For each point without a mark how many triangles there are around it if the triangles around it
/// certainly meet each other in nothing but the point and the edges that neighbours share: if they
/// make one closed fan that, seen along an axis of coordinates, goes around the point once, always
/// the same way, wherever each coordinate of each point moves by at most `margin`; else, and for
/// others, 0. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> injective_stars(std::span<const Vec3> points,
                                                         std::span<const Triangle> triangles,
                                                         std::span<const std::uint8_t> marked,
                                                         double margin = 0);

}  // namespace dupin::checking
