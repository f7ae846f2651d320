#pragma once

#include <vector>

#include "dupin/kernel/progress.h"
#include "exact_mesh.h"
#include "set_operation.h"

namespace dupin::detail {

/// An n-ary set operation as a sequence of corefinements: unions in a balanced tree per group of
/// operands whose boxes overlap. The operands use one table of names. Throws
/// Error{boolean_failed | cancelled}.
[[nodiscard]] ExactMesh combine_pairwise(SetOperation operation, std::vector<ExactMesh> operands,
                                         const Progress& progress);

}  // namespace dupin::detail
