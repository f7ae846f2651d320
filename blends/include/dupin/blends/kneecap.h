#pragma once

#include <span>
#include <vector>

#include "dupin/blends/pe_arc.h"

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

}  // namespace dupin
