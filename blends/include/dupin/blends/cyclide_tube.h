#pragma once

#include <string_view>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/tangency.h"
#include "dupin/kernel/enclosure.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A chain of cyclide pieces as a part of an assembly: G1 from piece to piece.
struct CyclideTube {
  Ring start, end;  ///< the stored end rings, normals pointing out of the tube
  CyclideChain chain;
  /// Thickness of a hollow tube, whose inner skin is the chain's offset and whose rims are conical
  /// strips along the normals; 0 for a solid one.
  double wall = 0;
};

/// The tube of a chain with the rings in which it begins and ends. Throws Error{infeasible_blend}
/// naming the piece whose inner skin is not regular, Error{invalid_argument} for a negative wall.
[[nodiscard]] CyclideTube cyclide_tube(CyclideChain chain, double wall = 0);

/// The space that the wall of a hollow tube encloses, its rings on the conical rims' inner edges;
/// their normals are the tube's, bitwise.
[[nodiscard]] CyclideTube inner_tube(const CyclideTube& tube);

/// Certified bounds of the margin along a piece: min(1 - kappa R) with the spheres' radius R and
/// the largest curvature kappa, per tangential length, that the surface's lines of curvature take
/// from the spine. 1 - kappa R for tori; positive if and only if the discs near each other are
/// disjoint. Closed form, rounded outward.
[[nodiscard]] Enclosure margin(const PeArc& arc);

/// The least over all pieces of the outer skin.
[[nodiscard]] Enclosure margin(const CyclideTube& tube);

/// A certified upper bound of the angle, in radians, between the tube's tangent planes at an end
/// and those of the cone or cylinder that its stored ring belongs to.
[[nodiscard]] double tangency_bound(const CyclideTube& tube, End end);

/// Of all skins, without end discs and rims.
[[nodiscard]] double area(const CyclideTube& tube);

/// Enclosed with the end discs; of a hollow tube, the wall's.
[[nodiscard]] double volume(const CyclideTube& tube);

/// "single", "double", "triple" or "chain", by the number of pieces.
[[nodiscard]] std::string_view kind(const CyclideTube& tube);

}  // namespace dupin
