#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/enclosure.h"

namespace dupin {

/// The chain of cyclide pieces that meet G1 as a part of an assembly, with the rings in which it
/// begins and ends; those at joints are the later piece's. Throws Error{infeasible_blend} naming
/// the piece whose inner skin is not regular, Error{invalid_argument} for a negative wall.
[[nodiscard]] Chain cyclide_tube(const CyclideChain& chain, double wall = 0);

/// The same between stored rings, solid.
[[nodiscard]] Chain cyclide_tube(const CyclideChain& chain, const Ring& start, const Ring& end);

/// A solid chain of cyclide pieces with a wall of this thickness, inwards. Throws PieceError naming
/// the piece whose inner skin is not regular, Error{invalid_argument} for a negative wall and for
/// other pieces.
[[nodiscard]] Chain hollow(Chain chain, double wall);

/// The space that the wall of a hollow chain encloses, its rings on the conical rims' inner edges;
/// the end rings' normals are the chain's, bitwise; its joints are of the chain's kind. Throws
/// Error{invalid_argument} for chains with other pieces than cyclides, Error{infeasible_blend} for
/// walls that are too thick.
[[nodiscard]] Chain inner_skin(const Chain& chain);

/// Certified bounds of the margin along a piece: min(1 - kappa R) with the spheres' radius R and
/// the largest curvature kappa, per tangential length, that the surface's lines of curvature take
/// from the spine. 1 - kappa R for tori; positive if and only if the discs near each other are
/// disjoint. Closed form, rounded outward.
[[nodiscard]] Enclosure margin(const PeArc& arc);

/// A certified upper bound of the angle, in radians, between the piece's tangent planes at an end
/// and those of the cone or cylinder that its stored ring belongs to.
[[nodiscard]] double tangency_bound(const CyclidePiece& piece, End end);

/// Of all skins of a chain of cyclides that meet smoothly, without end discs and rims.
[[nodiscard]] double area(const Chain& chain);

/// Enclosed with the end discs; of a hollow chain, the wall's.
[[nodiscard]] double volume(const Chain& chain);

/// "single", "double", "triple" or "chain", by the number of pieces.
[[nodiscard]] std::string_view kind(const Chain& chain);

/// Whether the tube (the union of the arc's balls) keeps more than `distance` >= 0 from a ball:
/// decided exactly on the given doubles (the start tangent taken to be PE-unit), closed form.
[[nodiscard]] bool keeps_distance(const PeArc& arc, const Sphere& ball, double distance);

/// Whether the point lies inside the tube, its surface not included; decided likewise.
[[nodiscard]] bool contains(const PeArc& arc, const Vec3& point);

/// The largest distance that the tube keeps from a ball; negative where they overlap, as far as
/// the radius that the ball would have to lose. Absolute error below 1e-12 of the size of the data.
[[nodiscard]] double clearance(const PeArc& arc, const Sphere& ball);
[[nodiscard]] double clearance(const CyclideChain& chain, const Sphere& ball);

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
