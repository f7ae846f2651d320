#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "mesh/exact_mesh.h"

/// What both engines of CGAL work on.
namespace dupin::cross_check {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

[[nodiscard]] Surface surface_mesh(const mesh::ExactMesh& mesh);

/// The boundary of a solid with the very coordinates, no labels, and {0, i} for sources. Where more
/// than one fan of faces is around a point, each gets its own. Throws Error{boolean_failed} unless
/// two triangles, which run along it in opposite directions, are at each edge; `what` made the
/// surface.
[[nodiscard]] mesh::ExactMesh exact_mesh(const Surface& surface, const std::string& what);

}  // namespace dupin::cross_check
