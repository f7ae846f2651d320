#pragma once

#include "dupin/blends/nurbs.h"
#include "dupin/blends/tessellation.h"
#include "surfaces/pieces/piece_operations.h"

namespace dupin::surfaces {

// What an elliptic tube is able to do: see surface_piece.h. Its discs are the circles about its
// ellipses.

[[nodiscard]] PieceExtent extent(const EllipticTube& piece, double wall);
[[nodiscard]] MovingRing leaving(const EllipticTube& piece, End end);
[[nodiscard]] std::uint32_t segments_for(const EllipticTube& piece, double tolerance, double grid);
[[nodiscard]] double expected_bands(const EllipticTube& piece, const RingSampling& sampling,
                                    double tolerance);
[[nodiscard]] Tessellation tessellate(const EllipticTube& piece, const RingSampling& sampling,
                                      const TessellationOptions& options);
[[nodiscard]] PieceDiscs discs(const EllipticTube& piece);
[[nodiscard]] MarginBounds margin_bounds(const EllipticTube& piece);
[[nodiscard]] double nearly_largest_margin(const EllipticTube& piece, double wall);
[[nodiscard]] ProvedStretches prove_margin(const EllipticTube& piece, double wall, double margin);
[[nodiscard]] std::optional<double> tangency(const EllipticTube& piece, End end);
[[nodiscard]] TangencyClaim tangency_claim(const EllipticTube& piece, End end);
[[nodiscard]] NurbsForm nurbs(const EllipticTube& piece, double tolerance);

}  // namespace dupin::surfaces
