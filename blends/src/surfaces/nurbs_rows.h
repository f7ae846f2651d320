#pragma once

#include <vector>

#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/nurbs.h"
#include "dupin/blends/ringed_surface.h"

namespace dupin::surfaces {

/// A row of control points of a surface of ellipses center + cos u a + sin u b, all multiplied by
/// the row's weight.
struct NurbsRow {
  Vec3 center, a, b;
  double weight = 1;
};

/// Knots of Bezier pieces of equal length, joined: (0, 0, 0, 1/4, 1/4, ..., 1, 1, 1).
[[nodiscard]] std::vector<double> bezier_knots(int degree, int pieces);

/// The nine points around of a row: quarters of an ellipse, the middle ones of weight sqrt(1/2).
[[nodiscard]] std::vector<std::array<double, 4>> row_points(const NurbsRow& row);

/// Bezier pieces of this degree along, which share their end rows.
[[nodiscard]] NurbsSurface nurbs_through(const std::vector<NurbsRow>& rows, int degree);

/// Throws Error{invalid_argument} for a tolerance that is not positive and finite.
void require_nurbs_tolerance(double tolerance);

/// The approximation of nurbs() to surfaces that are not rational.
[[nodiscard]] NurbsForm lofted_nurbs(const RingedSurface& surface, double tolerance);
[[nodiscard]] NurbsForm lofted_nurbs(const EllipticTube& tube, double tolerance);

}  // namespace dupin::surfaces
