#pragma once

#include <concepts>
#include <type_traits>
#include <variant>

#include "surfaces/pieces/cyclide_piece_operations.h"
#include "surfaces/pieces/elliptic_piece_operations.h"
#include "surfaces/pieces/rational_piece_operations.h"
#include "surfaces/pieces/ringed_piece_operations.h"

// The kinds of pieces that chains consist of. Each is one pair of files with one set of functions,
// which SurfacePiece states; whoever uses pieces visits them and calls these functions, so that a
// kind that lacks one does not compile, and says which. A new kind: its struct in a public header,
// its pair of files here, their include below, a line in Piece (part_surface.h).

namespace dupin::surfaces {

/// `wall` is the thickness of the chain's wall, 0 for a solid one; only cyclide pieces have one.
template <class P>
concept SurfacePiece = requires(const P& piece, End end, double number,
                                const RingSampling& sampling) {
  // The stored rings, shared with the neighbours bitwise; normals pointing out.
  { piece.start } -> std::convertible_to<Ring>;
  { piece.end } -> std::convertible_to<Ring>;
  { surfaces::leaving(piece, end) } -> std::same_as<MovingRing>;
  // How fine a mesh has to be, and the mesh: from the start's polygon to the end's, bitwise.
  { surfaces::extent(piece, number) } -> std::same_as<PieceExtent>;
  { surfaces::segments_for(piece, number, number) } -> std::same_as<std::uint32_t>;
  { surfaces::expected_bands(piece, sampling, number) } -> std::same_as<double>;
  {
    surfaces::tessellate(piece, sampling, TessellationOptions{number})
    } -> std::same_as<Tessellation>;
  { surfaces::nurbs(piece, number) } -> std::same_as<NurbsForm>;
  // Certificates: the discs, where they advance, and what is off at the ends.
  { surfaces::discs(piece) } -> std::same_as<PieceDiscs>;
  { surfaces::margin_bounds(piece) } -> std::same_as<MarginBounds>;
  { surfaces::nearly_largest_margin(piece, number) } -> std::same_as<double>;
  { surfaces::prove_margin(piece, number, number) } -> std::same_as<ProvedStretches>;
  { surfaces::tangency(piece, end) } -> std::same_as<std::optional<double>>;
  { surfaces::tangency_claim(piece, end) } -> std::same_as<TangencyClaim>;
};

/// A kind that lacks a function fails here, where the compiler says which one.
template <SurfacePiece>
struct CheckedPiece {};
template <class>
struct CheckedPieces;
template <class... Kinds>
struct CheckedPieces<std::variant<Kinds...>> : CheckedPiece<Kinds>... {};
template struct CheckedPieces<Piece>;

/// Kinds whose chains are swept together.
template <class P>
concept SweptTogether = requires(std::span<const P> run, const RingSampling& sampling) {
  surfaces::segments_for(run, 0.0, 0.0);
  surfaces::tessellate(run, sampling, TessellationOptions{});
};

}  // namespace dupin::surfaces
