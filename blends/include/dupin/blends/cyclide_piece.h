#pragma once

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A piece of a cyclide: the canal surface of the spheres (m; r) on the rational quadratic with the
/// homogeneous points first, (e first + D tangent / 2) / chord, D / chord^2 last and the weights 1,
/// e / chord, D / chord^2, where d = last - first, D = <d, d>, e = <d, tangent>. It is defined by
/// these numbers exactly, even where the tangent is a PE-unit vector only up to rounding.
struct CyclidePiece {
  Ring start, end;  ///< stored, normals pointing out of the piece
  PeVector first, tangent, last;
  double chord = 1;
};

/// The arc between its own contact circles.
[[nodiscard]] CyclidePiece cyclide_piece(const PeArc& arc);

/// The arc that the piece was made of, bitwise. Throws Error as PeArc::from for numbers that are no
/// arc's.
[[nodiscard]] PeArc arc_of(const CyclidePiece& piece);

}  // namespace dupin
