#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/pe_arc.h"

namespace dupin {

/// The pieces through each three spheres of which the last is the next piece's first ([SD94] UCCT):
/// they touch all spheres, but meet at the common ones in different circles, between which the
/// joint is a part of the sphere, its kneecap. Where the PE-unit tangent at the start is given, it
/// decides about the first piece instead of that piece's second sphere. Needs an odd number of
/// spheres, three at least. Throws PieceError where a piece is not regular.
[[nodiscard]] std::vector<PeArc> through_all(std::span<const PeVector> spheres,
                                             const std::optional<PeVector>& tangent = {});

/// A sphere in which two pieces meet. The piece before covers the cap about the backward direction
/// of its end tangent, the piece after that about the forward direction of its start tangent; the
/// kneecap is what is left.
struct SphericalJoint {
  PeVector sphere;
  double before = 0, after = 0;  ///< angular radii of the caps, in radians
  double between = 0;            ///< angle between the caps' axes
  double overlap_area = 0;       ///< of the caps: there the tubes penetrate each other
  double exposed_area = 0;       ///< of the kneecap

  /// No overlap: the kneecap is a band between the two circles.
  [[nodiscard]] bool is_clean() const { return between >= before + after; }
};

/// Throws Error{invalid_argument} unless `before` ends in the sphere where `after` starts, bitwise.
[[nodiscard]] SphericalJoint spherical_joint(const PeArc& before, const PeArc& after);

/// The chain through_all `spheres` with spherical joints: the union of its pieces, each between the
/// flat discs of its contact circles, and at every joint of what the ball has beyond the disc of
/// the piece before and ahead of that of the piece after. Throws PieceError{infeasible_blend} for a
/// piece that turns back into the one before it.
[[nodiscard]] Chain kneecap_chain(std::span<const PeVector> spheres,
                                  const std::optional<PeVector>& tangent = {});

}  // namespace dupin
