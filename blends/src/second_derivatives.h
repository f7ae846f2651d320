#pragma once

#include "dupin/blends/ringed_surface.h"
#include "dupin/blends/tessellate.h"

namespace dupin::detail {

/// The bounds together with one of |T'|, the speed at which the spine turns.
struct BandBounds {
  SecondDerivativeBounds second;
  double turning = 0;
};

/// See second_derivative_bounds().
[[nodiscard]] BandBounds band_bounds(const RingedSurface& surface, double from, double to);

}  // namespace dupin::detail
