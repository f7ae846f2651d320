#pragma once

#include <cmath>
#include <limits>

#include "dupin/blends/pe_arc.h"

namespace dupin::cyclide {

/// What cancellation may leave of equal tangents at the ends of pieces between two spheres: their
/// coordinates carry an error of an ulp of their size, which the tangent divides by the chord.
inline double tangent_rounding(const PeVector& start, const PeVector& end) {
  const double chord = std::sqrt(squared_tangential_distance(start, end));
  const double size = start.m.cwiseAbs().maxCoeff() + end.m.cwiseAbs().maxCoeff() +
                      (end.m - start.m).norm() + start.r + end.r;
  return 64 * std::numeric_limits<double>::epsilon() * size / chord;
}

}  // namespace dupin::cyclide
