#pragma once

#include <array>

#include <gmpxx.h>

namespace dupin::canal {

/// Homogeneous coordinates (x w, y w, z w, w).
using ExactPoint = std::array<mpq_class, 4>;

/// The Bernstein coefficients of degree 10 by q = tan(parameter / 2) in [0, 1], of the three
/// control points, by degree 2, of the arcs from the thicker cylinder to the other.
using ExactNet = std::array<std::array<ExactPoint, 11>, 3>;

/// The exact quarter, parameters 0 to pi/2, of the rational fillet between the cylinders of radius
/// `thick` around the x axis and `thin` < `thick` around the y axis with constant g = `size`
/// (mathematics B.8).
[[nodiscard]] ExactNet perpendicular_net(const mpq_class& thick, const mpq_class& thin,
                                         const mpq_class& size);

}  // namespace dupin::canal
