#pragma once

#include <vector>

#include "cross_check/set_operation.h"
#include "dupin/kernel/progress.h"
#include "mesh/exact_mesh.h"

namespace dupin::cross_check {

/// An n-ary set operation as a sequence of corefinements: unions in a balanced tree per group of
/// operands whose boxes overlap. The operands use one table of names. Throws
/// Error{boolean_failed | cancelled}.
[[nodiscard]] mesh::ExactMesh combine_pairwise(SetOperation operation,
                                               std::vector<mesh::ExactMesh> operands,
                                               const Progress& progress);

}  // namespace dupin::cross_check
