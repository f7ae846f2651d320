#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dupin/blends/assembly.h"

namespace dupin {

/// The position in Assembly::parts of the cyclide_chain with this name, or of the only one if there
/// is no name. Throws Error{invalid_argument}.
[[nodiscard]] std::uint32_t find_chain(const Assembly& assembly,
                                       const std::optional<std::string>& name);

/// The chain with one sphere moved, `sphere` being its position in CyclideChainThrough::spheres.
/// Pieces elsewhere stay bitwise the same, for which the result pins tangents.
///
/// A junction goes exactly there and three pieces change, the next junction staying as near
/// to its place as it can [SD94]; with `on_locus`, and for the last junction but one, two pieces
/// change and it goes to the nearest place that these allow. Of the last junction one piece
/// changes, of a bias sphere none. A chain with kneecaps changes in the pieces through the sphere.
/// Throws Error{infeasible_blend} where the pieces are not regular, Error{invalid_argument} for the
/// first junction, positions out of range and parts that are no cyclide_chain.
[[nodiscard]] CyclideChainThrough move_sphere(const Assembly& assembly, std::uint32_t part,
                                              std::size_t sphere, const PeVector& to,
                                              bool on_locus = false);

/// The chain with everything after a junction turned by `angle` radians about the axis of the
/// tangent cone there. Throws Error{invalid_argument} for a sphere that is no inner junction, an
/// angle that is not finite, a chain with kneecaps and parts that are no cyclide_chain.
[[nodiscard]] CyclideChainThrough twist_chain(const Assembly& assembly, std::uint32_t part,
                                              std::size_t sphere, double angle);

/// A piece of a chain that runs along the other segment of its arc than its bias sphere asks for:
/// the tangent it starts with forces it.
struct TurnedPiece {
  std::size_t piece = 0, bias_sphere = 0;  ///< the latter as in CyclideChainThrough::spheres
  /// Where to move which junction so that the piece turns to the bias sphere, coordinates of
  /// kPlaceDigits; of those that were tried, leave the margin and build, the nearest. Sphere first.
  std::optional<std::pair<std::size_t, PeVector>> remedy;
};

/// Those of a chain that resolves, with moves that were tried: of the junctions before and behind
/// the piece, towards the bias sphere and past it. None of a chain with kneecaps.
[[nodiscard]] std::vector<TurnedPiece> turned_pieces(const Assembly& assembly, std::uint32_t part,
                                                     double margin);

/// The least margin 1 - kappa R that edits leave, unless another is asked for: that of a
/// cyclide_blend.
constexpr double kEditMargin = 1.0 / 64;

/// Throws Error{irregular_surface} unless the chain's margin is proved to be at least `margin`,
/// Error{invalid_argument} for a number of no part, and what `build` throws. With `build_all`, all
/// parts are meshed and proved to be solids, and, where there are walls, united; without, the
/// document is resolved only, which is quick.
void check_edit(const Assembly& edited, std::uint32_t part, double margin, bool build_all = true);

/// Throws what `build` throws, of what it builds elsewhere, of a document put in another place: it
/// resolves, and numbers are still fine enough there for its tolerance and its parts.
void check_placement(const Assembly& placed);

}  // namespace dupin
