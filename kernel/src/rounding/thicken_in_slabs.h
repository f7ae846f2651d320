#pragma once

#include "rounding/edited_mesh.h"
#include "rounding/mesh_part.h"

namespace dupin::rounding {

/// thicken() of all faces of a mesh as given, by several threads: slabs of about as many points
/// first, each as a mesh of its own, then what is left at their borders.
///
/// Lemma: edits by collapses and flips of faces with all corners strictly between two planes make
/// such faces; these meet nothing but faces with some part there. So those within one slab do not
/// depend on those within another. The slabs depend on the mesh, not on the number of threads.
void thicken_in_slabs(EditedMesh& mesh, const BrokenMesh& original, double reach);

}  // namespace dupin::rounding
