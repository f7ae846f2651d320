#pragma once

#include "cross_check/boundary.h"
#include "cross_check/postfix.h"
#include "mesh/exact_mesh.h"

namespace dupin::cross_check {

/// The boundary of a set expression by CGAL's Nef polyhedra, in lazy exact arithmetic; regularised
/// once, at the end. Operands may have voids and may touch themselves where different shells do.
/// Throws Error{boolean_failed | cancelled}.
[[nodiscard]] Boundary boundary_by_nef(const Request& request, const Progress& progress);

/// The same as a mesh. Throws Error{boolean_failed} also where the boundary is no 2-manifold.
[[nodiscard]] mesh::ExactMesh mesh_by_nef(const Request& request, const Progress& progress);

}  // namespace dupin::cross_check
