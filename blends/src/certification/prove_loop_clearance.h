#pragma once

#include <cstddef>

#include "certification/swept_discs.h"
#include "dupin/blends/certificate.h"
#include "verification/claims/loop_clearance.h"

namespace dupin::certification {

/// The arcs of a loop, by the leaves of the claim that it is regular, as hulls of no radius; of
/// length 0 where that is undecided. The arcs outlive it.
[[nodiscard]] SweptDiscs swept_arcs(const verification::LoopArcs& arcs, SearchWork* work = nullptr);

/// A surface of a claim: what it is read from, and its discs or arcs.
struct SweptPart {
  const verification::Solid& solid;
  const SweptDiscs& sweep;
};
struct SweptLoop {
  const verification::LoopArcs& arcs;
  const SweptDiscs& sweep;
};

/// How much a search may cost, and how far apart what it calls one corner may be.
struct ClearanceGoals {
  std::size_t boxes = 0;
  double corner = 0;
};

/// A lower bound of the distance of a part and a loop, or a point of the loop inside the part, or
/// that they have nothing in common but corners.
[[nodiscard]] ClearanceClaim prove_clearance(const SweptPart& part, const SweptLoop& loop,
                                             const ClearanceGoals& goals);

/// A lower bound of the distance of two loops, or that they have nothing in common but corners.
[[nodiscard]] ClearanceClaim prove_clearance(const SweptLoop& first, const SweptLoop& second,
                                             const ClearanceGoals& goals);

}  // namespace dupin::certification
