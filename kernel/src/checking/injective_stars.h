#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

/// Points whose triangles do not fold over each other.
///
/// Lemma. The triangles around a point that make one closed fan, and seen along an axis go round it
/// once, each turning the same way by less than half a turn, are the graph of a function over a
/// star in the plane: the projection is injective. So they meet in the point and in common edges
/// only.
namespace dupin::checking {

/// For each point without a mark how many triangles there are around it if these certainly meet
/// each other in nothing but the point and the edges that neighbours share, by the lemma, wherever
/// each coordinate of each point moves by at most `margin`; else, and for others, 0. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> injective_stars(std::span<const Vec3> points,
                                                         std::span<const Triangle> triangles,
                                                         std::span<const std::uint8_t> marked,
                                                         double margin = 0);

}  // namespace dupin::checking
