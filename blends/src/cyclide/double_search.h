#pragma once

#include <functional>

#include "dupin/blends/cyclide_chain.h"

namespace dupin::cyclide {

/// The double-cyclide blend of least `objective`, which is infinite for those that will not do.
/// Throws Error{infeasible_blend} if there is none.
[[nodiscard]] DoubleCyclide best_double(
    const PeVector& start, const PeVector& start_tangent, const PeVector& end,
    const PeVector& end_tangent, const std::function<double(const DoubleCyclide&)>& objective);

}  // namespace dupin::cyclide
