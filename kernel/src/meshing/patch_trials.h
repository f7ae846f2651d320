#pragma once

#include <span>

#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"
#include "meshing/patch_topology.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// Where triangles still have a smaller angle than `wanted`, in radians, after moves of points and
/// edits of edges, though not between two edges of the chains: tries what makes angles smaller at
/// first, an edge cut in two or a point drawn into a neighbour, each followed by moves and edits of
/// what is about the triangle, and keeps the best of what comes of it. The border of what is about
/// it and edges of the chains stay, a 2-manifold stays one. Looks at a number of triangles that is
/// bounded by that of all. Whether anything has changed. For surfaces without tetrahedra.
bool try_patches(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                 std::span<const BorderChain> chains, double wanted, const MoveLimits& limits);

}  // namespace dupin::meshing
