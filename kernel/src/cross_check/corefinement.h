#pragma once

#include "dupin/kernel/set_operation.h"
#include "mesh/exact_mesh.h"

namespace dupin::cross_check {

/// One set operation on two solids by CGAL's corefinement of their surfaces, in lazy exact
/// arithmetic: no point is rounded. Throws Error{boolean_failed} where the result touches itself
/// along an edge, where an operand touches itself, and where CGAL's algorithm fails.
[[nodiscard]] mesh::ExactMesh corefine(SetOperation operation, const mesh::ExactMesh& a,
                                       const mesh::ExactMesh& b);

}  // namespace dupin::cross_check
