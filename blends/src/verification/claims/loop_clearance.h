#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/certificate.h"
#include "verification/claims/fillet_claims.h"
#include "verification/solid.h"

// How far the surface of a fillet's loop, the union of its arcs, is from parts and other loops. The
// lemmas are in docs/certificate_format.md.

namespace dupin::verification {

/// A loop and the leaves of the claim that it is regular; none where that is undecided.
struct LoopArcs {
  const CanalFillet* loop = nullptr;
  std::vector<ArcCell> cells;
};

/// Whether both have the same corners: they are the two loops of pipes that touch.
[[nodiscard]] bool share_corners(const CanalFillet& first, const CanalFillet& second);

/// How far apart at most the corners are in which the stretches end, if all arcs of the first one
/// are behind its corner, and those of the second one in front of its own; infinite if not. 0 for
/// loops that share their corners.
[[nodiscard]] double gap_at_corner(const LoopArcs& first, const LoopArcs& second,
                                   const DiscPairs& leaf);

/// How far at most the part's stretch reaches, along the direction, beyond the corner in which the
/// loop's ends, if all arcs of that are in front of the corner; infinite if not.
[[nodiscard]] double gap_at_corner(const Solid& part, const LoopArcs& loop, const DiscPairs& leaf);

/// A place on the loop, one of both feet or the middle of the arc, such that it and the point
/// are inside discs of the part.
[[nodiscard]] bool follows(const Overlap& overlap, const Solid& part, const CanalFillet& loop);

/// Whether a claim that is not undecided follows.
[[nodiscard]] bool follows(const Solid& part, const LoopArcs& loop, const ClearanceClaim& claim);
[[nodiscard]] bool follows(const LoopArcs& first, const LoopArcs& second,
                           const ClearanceClaim& claim);

}  // namespace dupin::verification
