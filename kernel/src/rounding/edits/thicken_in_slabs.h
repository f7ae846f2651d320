#pragma once

#include <cstdint>
#include <vector>

#include "mesh/exact_mesh.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/edits/mesh_part.h"

namespace dupin::rounding {

/// Whether rounding, to these points, leaves nothing of so many triangles, and of such a part of
/// all, that it is no accident: what is thinner than a step is thickened first. One triangle in
/// some is looked at.
[[nodiscard]] bool is_full_of_needles(const mesh::MeshView& rounded);

/// thicken() of the faces of a mesh as given, by several threads: in slabs of about as many points,
/// each as a mesh of its own. Returns those that are left, at their borders, for thicken() of the
/// whole mesh; all, if it is too small for slabs.
///
/// Lemma: edits by collapses and flips of faces with all corners strictly between two planes make
/// such faces; these meet nothing but faces with some part there. So those within one slab do not
/// depend on those within another. The slabs depend on the mesh, not on the number of threads.
[[nodiscard]] std::vector<std::uint32_t> thicken_in_slabs(EditedMesh& mesh,
                                                          const BrokenMesh& original, double reach);

}  // namespace dupin::rounding
