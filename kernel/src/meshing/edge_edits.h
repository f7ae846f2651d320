#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"
#include "meshing/patch_topology.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// Two points, the lower one first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;
[[nodiscard]] Edge edge_of(std::uint32_t a, std::uint32_t b);
[[nodiscard]] bool has(const Triangle& triangle, std::uint32_t point);
[[nodiscard]] std::set<Edge> edges_of(std::span<const BorderChain> chains);

/// Takes triangles away, and points of regions that no triangle has any more; what is left keeps
/// its order.
void take_away(Tetrahedra& mesh, const std::vector<std::uint8_t>& is_gone);

/// Changes which points of a surface triangles join, where one has a smaller angle than `wanted`,
/// in radians: edges are turned in their two triangles, and points that may move are drawn into a
/// neighbour, as where refinement has cut a triangle between two sharp edges, whose angle stays.
/// Each edit makes the smallest angle of what it changes larger, turns no triangle by a right
/// angle, leaves edges of the chains, and looks near; a 2-manifold stays one, and points that no
/// triangle has any more are taken away. Whether there was any. For surfaces without tetrahedra.
bool edit_edges(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                std::span<const BorderChain> chains, double wanted, const MoveLimits& limits);

}  // namespace dupin::meshing
