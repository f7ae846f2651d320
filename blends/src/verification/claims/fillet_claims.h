#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "dupin/blends/certificate.h"
#include "verification/motions/contact_arcs.h"
#include "verification/motions/taylor_jet.h"
#include "verification/piece.h"

// Whether claims about a loop of a fillet follow from its numbers and its quadrics'. The lemmas and
// their proofs are in docs/certificate_format.md.

namespace dupin::verification {

/// A leaf of a claim that a loop is regular, and its arcs, of which other claims make use.
struct ArcCell {
  ParameterInterval t;
  ContactArcs arcs;
  /// Upper bounds of |x_chi chi|, |x_chi u| and |x_u u|, u going from 0 to 1 along every arc, and
  /// of how far the arcs are from the origin.
  double along = 0, mixed = 0, around = 0, size = 0;
};

/// The leaves of a claim that is proved, if it follows.
[[nodiscard]] std::optional<std::vector<ArcCell>> regular_cells(const CanalFillet& loop,
                                                                const RegularClaim& claim);

/// The leaf of a claim with this margin, if it holds.
[[nodiscard]] std::optional<ArcCell> regular_cell(const CanalFillet& loop,
                                                  const ParameterInterval& leaf, double margin);

/// Whether the claim says nothing besides its verdict and margin.
[[nodiscard]] bool has_form(const RegularClaim& claim);

/// Whether a claim that is proved follows. O((leaves + cells) log).
[[nodiscard]] bool follows(const CanalFillet& loop, const std::vector<ArcCell>& cells,
                           const EmbeddedClaim& claim);

/// The cells that a stretch meets.
[[nodiscard]] std::span<const ArcCell> cells_of(const std::vector<ArcCell>& cells,
                                                const ParameterInterval& t);

/// An upper bound of x.d for the points of their arcs.
[[nodiscard]] double furthest(std::span<const ArcCell> way, const IntervalVec& d);

/// Whether all points of the arcs move along d.
[[nodiscard]] bool moves_along(std::span<const ArcCell> way, const IntervalVec& d);

/// Whether a leaf of such a claim holds. O(cells that it meets).
[[nodiscard]] bool holds(const CanalFillet& loop, const std::vector<ArcCell>& cells,
                         const DiscPairs& leaf);

[[nodiscard]] bool follows(const CanalFillet& loop, const ContactClaim& claim);

/// What a ball rolls between: the rings of its pipes that are no quadrics of the loop, and how far
/// both are from these at most.
struct RolledPipes {
  std::array<Ring, 2> starts;
  ConeDifference difference;
};

/// Pipes of one piece each, with a single tube.
[[nodiscard]] RolledPipes rolled_pipes(const std::array<Ring, 2>& quadrics,
                                       const std::array<const Piece*, 2>& pipes);

/// What a claim about pipes leaves for their quadrics, which differ from the pipes by so much.
[[nodiscard]] ContactClaim about_quadrics(const ContactClaim& claim,
                                          const ConeDifference& difference);

/// Whether it is found to on this stretch alone, of which both ends are in one half of the loop.
[[nodiscard]] bool touches_on(const CanalFillet& loop, const ContactClaim& claim,
                              const ParameterInterval& t);

/// Whether the ball's feet on both quadrics are beyond neither ring of the pipes by more than the
/// tolerance; `starts` are those that are no quadrics of the loop.
[[nodiscard]] bool touches_between(const CanalFillet& loop, const std::array<Ring, 2>& starts,
                                   double tolerance);

/// Of the mesh that has rows at the knots, and all arcs there divided into so many segments, an
/// upper bound of the error; infinite where none is found.
[[nodiscard]] double mesh_error(const std::vector<ArcCell>& cells, const MeshClaim& claim);
[[nodiscard]] bool follows(const std::vector<ArcCell>& cells, const MeshClaim& claim);

/// Enclosures of a function over a stretch and of its derivative.
struct TaylorRange {
  Interval value, slope;
};

/// By Taylor's formula, of the function at the middle and on all of a stretch that reaches so far
/// from there: of the last derivative the latter.
template <std::size_t count>
[[nodiscard]] TaylorRange taylor_range(const Jet<count>& middle, const Jet<count>& all,
                                       double reach) {
  return {taylor_sum(middle, all, reach, 0), taylor_sum(middle, all, reach, 1)};
}

}  // namespace dupin::verification
