#pragma once

#include <array>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// A tensor-product NURBS surface: rows of control points along a part, columns around it.
struct NurbsSurface {
  int degree_along = 1, degree_around = 2;
  /// With end knots repeated degree + 1 times, from 0 to 1; as many as points and degree + 1.
  std::vector<double> knots_along, knots_around;
  std::vector<std::vector<std::array<double, 4>>> net;  ///< (x w, y w, z w, w), all w > 0
};

/// Its point at parameters in [0, 1].
[[nodiscard]] Vec3 evaluate(const NurbsSurface& surface, double along, double around);

/// The lateral surface of a part.
struct NurbsForm {
  std::vector<NurbsSurface> surfaces;
  /// No point of the NURBS is further from the part's surface than this; 0: they are the same, up
  /// to the rounding of the control points.
  double error_bound = 0;
};

}  // namespace dupin
