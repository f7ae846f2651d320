#pragma once

#include "dupin/blends/nurbs.h"
#include "dupin/blends/tessellation.h"
#include "surfaces/pieces/piece_operations.h"

namespace dupin::surfaces {

// What a normal ringed surface is able to do: see surface_piece.h.

[[nodiscard]] PieceExtent extent(const RingedSurface& piece, double wall);
[[nodiscard]] MovingRing leaving(const RingedSurface& piece, End end);
[[nodiscard]] std::uint32_t segments_for(const RingedSurface& piece, double tolerance, double grid);
[[nodiscard]] double expected_bands(const RingedSurface& piece, const RingSampling& sampling,
                                    double tolerance);
[[nodiscard]] Tessellation tessellate(const RingedSurface& piece, const RingSampling& sampling,
                                      const TessellationOptions& options);
[[nodiscard]] PieceDiscs discs(const RingedSurface& piece);
[[nodiscard]] MarginBounds margin_bounds(const RingedSurface& piece);
[[nodiscard]] double nearly_largest_margin(const RingedSurface& piece, double wall);
[[nodiscard]] ProvedStretches prove_margin(const RingedSurface& piece, double wall, double margin);
[[nodiscard]] std::optional<double> tangency(const RingedSurface& piece, End end);
[[nodiscard]] TangencyClaim tangency_claim(const RingedSurface& piece, End end);
[[nodiscard]] NurbsForm nurbs(const RingedSurface& piece, double tolerance);

/// Whether this is a torus segment that does not meet itself: its circles, in half planes about the
/// axis, do not reach it, and make less than a turn. Decided exactly.
[[nodiscard]] bool is_embedded_torus(const RingedSurface& piece);

}  // namespace dupin::surfaces
