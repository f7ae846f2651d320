#pragma once

#include "dupin/blends/nurbs.h"
#include "dupin/blends/tessellation.h"
#include "surfaces/pieces/piece_operations.h"

namespace dupin::surfaces {

// What a rational ringed tube is able to do: see surface_piece.h.

[[nodiscard]] PieceExtent extent(const RationalRingedTube& piece, double wall);
[[nodiscard]] MovingRing leaving(const RationalRingedTube& piece, End end);
[[nodiscard]] std::uint32_t segments_for(const RationalRingedTube& piece, double tolerance,
                                         double grid);
[[nodiscard]] double expected_bands(const RationalRingedTube& piece, const RingSampling& sampling,
                                    double tolerance);
[[nodiscard]] Tessellation tessellate(const RationalRingedTube& piece, const RingSampling& sampling,
                                      const TessellationOptions& options);
[[nodiscard]] PieceDiscs discs(const RationalRingedTube& piece);
[[nodiscard]] MarginBounds margin_bounds(const RationalRingedTube& piece);
[[nodiscard]] double nearly_largest_margin(const RationalRingedTube& piece, double wall);
[[nodiscard]] ProvedStretches prove_margin(const RationalRingedTube& piece, double wall,
                                           double margin);
[[nodiscard]] std::optional<double> tangency(const RationalRingedTube& piece, End end);
[[nodiscard]] TangencyClaim tangency_claim(const RationalRingedTube& piece, End end);
[[nodiscard]] NurbsForm nurbs(const RationalRingedTube& piece, double tolerance);

}  // namespace dupin::surfaces
