#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/error.h"

namespace dupin {

/// The PE-unit tangent at `first` of the one cyclide through three spheres ([SD94] UCCT). Throws
/// Error{infeasible_blend} when one of the three contains another.
[[nodiscard]] PeVector initial_tangent(const PeVector& first, const PeVector& second,
                                       const PeVector& third);

/// The piece through three spheres in order ([SD94] UCCT). Throws Error{infeasible_blend} where the
/// piece is not regular or the second sphere does not lie between the others.
[[nodiscard]] PeArc through_three(const PeVector& first, const PeVector& second,
                                  const PeVector& third);

/// The fault of one piece of a chain; part() is "piece 2" for the third one.
class PieceError : public Error {
 public:
  PieceError(std::size_t piece, const Error& error)
      : Error(error.in_part("piece " + std::to_string(piece))), piece_(piece) {}

  [[nodiscard]] std::size_t piece() const noexcept { return piece_; }

 private:
  std::size_t piece_;
};

/// Pieces that meet G1: each starts in the sphere in which the one before ends, bitwise, and in its
/// tangent, bitwise but for edited chains, where rounding may part them.
struct CyclideChain {
  std::vector<PeArc> pieces;
};

/// The tangent with which the piece after a sphere begins: the arriving one up to rounding, so that
/// a piece stays bitwise the same when one before it changes.
struct PinnedTangent {
  std::size_t sphere = 0;  ///< index
  PeVector tangent;        ///< PE-unit
};

/// The chain of [SD94] TCCT: junctions are the spheres of even index; those of odd index say on
/// which side the designer expects the piece (see `bias_warnings`). Needs an odd number of spheres,
/// three at least. Throws PieceError where a piece is not regular, Error{invalid_argument} for a
/// pinned tangent that differs from the arriving one by more than rounding.
[[nodiscard]] CyclideChain compose(std::span<const PeVector> spheres, const PeVector& tangent,
                                   std::span<const PinnedTangent> pinned = {});

/// Pieces whose bias sphere is nearer (in R^4) to the complementary arc than to the piece that the
/// tangent forces.
[[nodiscard]] std::vector<std::size_t> bias_warnings(const CyclideChain& chain,
                                                     std::span<const PeVector> spheres);

/// The integral of the squared PE curvature along the piece.
[[nodiscard]] double bending(const PeArc& arc);

/// Two pieces from (start, start_tangent) to (end, end_tangent); `tau` in (0, 1) places the
/// junction on its locus.
struct DoubleCyclide {
  PeArc first, second;
  double tau = 0;
};

/// The double-cyclide blend ([SD94] DCET by the junction locus) for the given tau. Throws
/// Error{infeasible_blend}.
[[nodiscard]] DoubleCyclide double_cyclide(const PeVector& start, const PeVector& start_tangent,
                                           const PeVector& end, const PeVector& end_tangent,
                                           double tau);

/// The double-cyclide blend of least bending (sum of the squared PE curvatures along the arcs).
[[nodiscard]] DoubleCyclide double_cyclide(const PeVector& start, const PeVector& start_tangent,
                                           const PeVector& end, const PeVector& end_tangent);

/// The double-cyclide blend whose junction lies nearest, in R^4, to `sphere`.
[[nodiscard]] DoubleCyclide double_cyclide_near(const PeVector& start,
                                                const PeVector& start_tangent, const PeVector& end,
                                                const PeVector& end_tangent,
                                                const PeVector& sphere);

/// The result of a local edit: the new chain and the indices of the pieces that differ; all others
/// are bitwise the same.
struct EditedChain {
  CyclideChain chain;
  std::vector<std::size_t> changed;
};

/// Moves the junction after piece `junction - 1` towards `sphere`: two pieces change, the junction
/// is the point of its locus nearest to the sphere. 1 <= junction < pieces.
[[nodiscard]] EditedChain move_on_locus(const CyclideChain& chain, std::size_t junction,
                                        const PeVector& sphere);

/// Puts the junction exactly at `sphere`: three pieces change ([SD94] TCET), the following junction
/// stays as near to its place as it can. 1 <= junction < pieces - 1.
[[nodiscard]] EditedChain move_junction(const CyclideChain& chain, std::size_t junction,
                                        const PeVector& sphere);

/// Turns everything after the junction by `angle` about the axis of its tangent cone; G1 is
/// preserved.
[[nodiscard]] EditedChain twist(const CyclideChain& chain, std::size_t junction, double angle);

/// The chain at distance `h` along the outward normal.
[[nodiscard]] CyclideChain offset(const CyclideChain& chain, double h);

}  // namespace dupin
