#pragma once

#include "dupin/blends/pe_arc.h"

namespace dupin::cyclide {

/// validity() with the fault decided on the rounded numbers: for searches, without rational
/// arithmetic.
[[nodiscard]] ArcValidity rounded_validity(const PeVector& start, const PeVector& tangent,
                                           const PeVector& end);

}  // namespace dupin::cyclide
