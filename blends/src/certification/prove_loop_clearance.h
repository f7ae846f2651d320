#pragma once

#include <cstddef>

#include "certification/swept_discs.h"
#include "dupin/blends/certificate.h"
#include "verification/loop_clearance.h"

namespace dupin::certification {

/// The arcs of a loop, by the leaves of the claim that it is regular, as hulls of no radius; of
/// length 0 where that is undecided. The arcs outlive it.
[[nodiscard]] SweptDiscs swept_arcs(const verification::LoopArcs& arcs, SearchWork* work = nullptr);

/// A lower bound of the distance of a part and a loop, or a point of the loop inside the part.
[[nodiscard]] ClearanceClaim prove_clearance(const SweptDiscs& part,
                                             const verification::LoopArcs& arcs,
                                             const SweptDiscs& loop, std::size_t boxes);

/// A lower bound of the distance of two loops, or that they have nothing in common but corners.
[[nodiscard]] ClearanceClaim prove_clearance(const verification::LoopArcs& first,
                                             const SweptDiscs& first_sweep,
                                             const verification::LoopArcs& second,
                                             const SweptDiscs& second_sweep, std::size_t boxes);

}  // namespace dupin::certification
