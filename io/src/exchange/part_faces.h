#pragma once

#include <cstddef>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "exchange/exchange_model.h"

namespace dupin::exchange {

[[nodiscard]] RingCurve ring_curve(const Ring& ring);

/// How many surfaces were exact, and how far the others are from what they stand for.
struct SurfaceCount {
  std::size_t exact = 0, lofted = 0;
  double error = 0;
};

/// A face of a piece, whose rings are not yet in a list: those of the piece.
using PieceSurface = decltype(TubeFace::surface);

/// The surface of a piece: analytic where it is a cylinder, cone or torus of revolution about its
/// axis, else one NURBS surface whose columns close around and whose rows run along. Throws
/// Error{boolean_failed} where the patches of a piece make no such surface.
[[nodiscard]] PieceSurface piece_surface(const Piece& piece, double tolerance, SurfaceCount& count);

}  // namespace dupin::exchange
