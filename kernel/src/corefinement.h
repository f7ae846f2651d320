#pragma once

#include "exact_mesh.h"
#include "set_operation.h"

namespace dupin::detail {

/// One set operation on two solids by CGAL's corefinement of their surfaces, in lazy exact
/// arithmetic. Both use one table of names; sources are handed on. The slower oracle of the
/// arrangement; it refuses more: throws Error{boolean_failed} where the result touches itself along
/// an edge, where an operand touches itself, and where CGAL's algorithm fails.
[[nodiscard]] ExactMesh corefine(SetOperation operation, const ExactMesh& a, const ExactMesh& b);

}  // namespace dupin::detail
