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

/// The surfaces of a piece, one after the other along it: analytic where it is a cylinder, cone or
/// torus of revolution about its axis, else NURBS whose columns close around and whose rows run
/// along. Several of cyclides, which meet in circles. Throws Error{boolean_failed} where patches of
/// a piece make no such surface.
[[nodiscard]] std::vector<PieceSurface> piece_surfaces(const Piece& piece, double tolerance,
                                                       SurfaceCount& count);

/// The circle in which a surface of circles ends.
[[nodiscard]] RingCurve end_circle(const NurbsSurface& surface);

}  // namespace dupin::exchange
