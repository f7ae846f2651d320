#pragma once

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/pe_arc.h"

namespace dupin {

/// A piece by canonical parameters. Along the ellipse or torus circle (theta): centre (a cos, b
/// sin, 0), radius mu - c cos; along the hyperbola (psi): centre (c / cos, 0, -b tan), radius mu -
/// a / cos; along the parabola (t): centre (t^2 / 2p, t, 0), radius mu - t^2 / 2p.
struct CanonicalPiece {
  CanonicalCyclide form;
  bool along_hyperbola = false;
  double from = 0, to = 1;  ///< the parameter at the ends; the piece runs from one to the other
};

/// Requires a kind other than cone and cylinder; throws Error{invalid_argument} otherwise.
[[nodiscard]] CanonicalPiece canonical_piece(const PeArc& arc);

/// The other way round. Throws Error{invalid_argument} for cones, cylinders and pieces that pass a
/// whole turn or infinity, Error{infeasible_blend} where the piece is not regular.
[[nodiscard]] PeArc arc_of(const CanonicalPiece& piece);

}  // namespace dupin
