#pragma once

#include <span>

#include "dupin/blends/nurbs.h"
#include "dupin/blends/tessellation.h"
#include "surfaces/pieces/piece_operations.h"

namespace dupin::surfaces {

// What a piece of a cyclide is able to do: see surface_piece.h.

[[nodiscard]] PieceExtent extent(const CyclidePiece& piece, double wall);
[[nodiscard]] MovingRing leaving(const CyclidePiece& piece, End end);
[[nodiscard]] std::uint32_t segments_for(const CyclidePiece& piece, double tolerance, double grid);
[[nodiscard]] double expected_bands(const CyclidePiece& piece, const RingSampling& sampling,
                                    double tolerance);
[[nodiscard]] Tessellation tessellate(const CyclidePiece& piece, const RingSampling& sampling,
                                      const TessellationOptions& options);
[[nodiscard]] PieceDiscs discs(const CyclidePiece& piece);
[[nodiscard]] MarginBounds margin_bounds(const CyclidePiece& piece);
[[nodiscard]] double nearly_largest_margin(const CyclidePiece& piece, double wall);
[[nodiscard]] ProvedStretches prove_margin(const CyclidePiece& piece, double wall, double margin);
[[nodiscard]] std::optional<double> tangency(const CyclidePiece& piece, End end);
[[nodiscard]] TangencyClaim tangency_claim(const CyclidePiece& piece, End end);
[[nodiscard]] NurbsForm nurbs(const CyclidePiece& piece, double tolerance);

/// Pieces that meet smoothly are swept together: their frame goes on through the joints, where the
/// rows are not the polygons of stored rings.
[[nodiscard]] std::uint32_t segments_for(std::span<const CyclidePiece> run, double tolerance,
                                         double grid);
[[nodiscard]] Tessellation tessellate(std::span<const CyclidePiece> run,
                                      const RingSampling& sampling,
                                      const TessellationOptions& options);

}  // namespace dupin::surfaces
