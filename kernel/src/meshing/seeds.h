#pragma once

#include <vector>

#include "dupin/kernel/mesh.h"
#include "mesh/surface_distance.h"
#include "meshing/delaunay_refinement.h"
#include "meshing/edge_lengths.h"
#include "meshing/features.h"

namespace dupin::meshing {

/// Where meshes of regions begin. Of each region, three points so near each other that they make a
/// triangle of its mesh [BO05, persistent facets], about the middle of a large triangle, and those
/// that lie furthest along the axes.
[[nodiscard]] std::vector<Seed> seeds_of(const TriMesh& mesh, const Features& features,
                                         const mesh::ReferenceSurface& surface,
                                         const EdgeLengths& lengths);

}  // namespace dupin::meshing
