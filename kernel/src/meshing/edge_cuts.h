#pragma once

#include <span>

#include "mesh/surface_distance.h"
#include "meshing/patch_topology.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// Cuts edges of a surface in two, other than those of the chains, whose middle is further than
/// `distance` from it, or that of a triangle whose longest they are; the new points lie on it.
/// Refinement looks at circumcentres of triangles, and edges across a bend may be further off.
/// Edges whose halves would turn a triangle by a right angle stay. Whether any was cut. For
/// surfaces without tetrahedra, of one region.
bool cut_far_edges(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                   std::span<const BorderChain> chains, double distance);

}  // namespace dupin::meshing
