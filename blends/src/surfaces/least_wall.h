#pragma once

#include <optional>

#include "dupin/blends/part_surface.h"

namespace dupin::surfaces {

/// A proved lower bound of the distance between a surface and its bore, whose sections have radii
/// less by the wall: of cyclides and balls the bore is parallel to them, and it is the wall. None
/// of oblique pieces.
///
/// A point of the bore is at least d inside of its section, d being the wall, or of ellipses what
/// is left of it across (ellipse_wall). On a way out of the part, sections move by at least m ds,
/// where m is the margin min(1 - kappa R), and widen by at most s ds: the way is no shorter than
/// d m / sqrt(m^2 + s^2).
[[nodiscard]] std::optional<double> least_wall(const PartSurface& surface, double wall);

/// A lower bound of the distance between an ellipse and the one whose semi-axes are less by `wall`:
/// that of their supports in one direction u, w (2 (a u1^2 + b u2^2) - w) / (h + h').
[[nodiscard]] double ellipse_wall(double a, double b, double wall);

}  // namespace dupin::surfaces
