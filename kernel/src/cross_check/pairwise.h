#pragma once

#include "cross_check/postfix.h"
#include "mesh/exact_mesh.h"

namespace dupin::cross_check {

/// A set expression as a sequence of corefinements: unions in a balanced tree per group of operands
/// whose boxes overlap. Throws Error{boolean_failed | cancelled}.
[[nodiscard]] mesh::ExactMesh mesh_by_corefinement(const Request& request,
                                                   const Progress& progress);

}  // namespace dupin::cross_check
