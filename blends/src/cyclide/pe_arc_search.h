#pragma once

#include <functional>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/pe_arc.h"

namespace dupin::cyclide {

/// The double-cyclide blend whose junction is that of the locus at `tau` in (0, 1). Throws
/// Error{infeasible_blend} if there is no locus or its sphere gives no two regular pieces.
[[nodiscard]] DoubleCyclide double_at(const PeVector& start, const PeVector& start_tangent,
                                      const PeVector& end, const PeVector& end_tangent, double tau);

/// The double-cyclide blend of least `objective`, which is infinite for those that will not do.
/// Throws Error{infeasible_blend} if there is none.
[[nodiscard]] DoubleCyclide best_double(
    const PeVector& start, const PeVector& start_tangent, const PeVector& end,
    const PeVector& end_tangent, const std::function<double(const DoubleCyclide&)>& objective);

/// Throws Error{infeasible_blend} if the junctions' locus is missing or passes so close to infinity
/// that the least bent junction is a far detour: where it passes infinity itself, rounding would
/// choose between no locus and one of any size.
void refuse_far_locus(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                      const PeVector& end_tangent);

/// What cancellation may leave of equal tangents at the ends of pieces between two spheres: their
/// coordinates carry an error of an ulp of their size, which the tangent divides by the chord.
[[nodiscard]] double tangent_rounding(const PeVector& start, const PeVector& end);

}  // namespace dupin::cyclide
