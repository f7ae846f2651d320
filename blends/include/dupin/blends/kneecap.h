#pragma once

#include <span>
#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/enclosure.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// The pieces through each three spheres of which the last is the next piece's first ([SD94] UCCT):
/// they touch all spheres, but meet at the common ones in different circles, between which the
/// joint is a part of the sphere, its kneecap. Needs an odd number of spheres, three at least.
/// Errors name the piece ("piece 2").
[[nodiscard]] std::vector<PeArc> through_all(std::span<const PeVector> spheres);

/// A sphere in which two pieces meet. The piece before covers the cap about the backward direction
/// of its end tangent, the piece after that about the forward direction of its start tangent; the
/// kneecap is what is left.
struct Kneecap {
  PeVector sphere;
  double before = 0, after = 0;  ///< angular radii of the caps, in radians
  double between = 0;            ///< angle between the caps' axes
  double overlap_area = 0;       ///< of the caps: there the tubes penetrate each other
  double exposed_area = 0;       ///< of the kneecap

  /// No overlap: the kneecap is a band between the two circles.
  [[nodiscard]] bool is_clean() const { return between >= before + after; }
};

/// Throws Error{invalid_argument} unless `before` ends in the sphere where `after` starts, bitwise.
[[nodiscard]] Kneecap kneecap(const PeArc& before, const PeArc& after);

/// A chain with kneecaps as a part of an assembly: the union of its pieces, each between the flat
/// discs of its contact circles, and at every joint of what the ball has beyond the disc of the
/// piece before and ahead of that of the piece after.
struct KneecapChain {
  Ring start, end;            ///< the stored end rings, normals pointing out
  std::vector<PeArc> pieces;  ///< each starts in the sphere in which the one before ends, bitwise
};

/// The chain through_all `spheres`. Throws Error{infeasible_blend}, which names the piece, for one
/// that turns back into the one before it.
[[nodiscard]] KneecapChain kneecap_chain(std::span<const PeVector> spheres);

/// The least margin of the pieces, see cyclide_tube.h.
[[nodiscard]] Enclosure margin(const KneecapChain& chain);

}  // namespace dupin
