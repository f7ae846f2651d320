#pragma once

#include <cstdint>
#include <vector>

#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_surface.h"
#include "numbers/interval.h"

namespace dupin::ringed {

/// Over an interval of t: the speed v = |y'|, and bounds of |v'|, |T'| and the part of T'' across
/// T.
struct SpineBounds {
  numbers::Interval speed;
  double acceleration = 0, turning = 0, turning_change = 0;
};

/// Over an interval of t: bounds of the radius and of the absolute values of its derivatives.
struct RadiusBounds {
  double value = 0, first = 0, second = 0;
};

/// Throws Error{irregular_surface} if the spine may stop in t.
[[nodiscard]] SpineBounds spine_bounds(const Spine& spine, const numbers::Interval& t);
[[nodiscard]] RadiusBounds radius_bounds(const RadiusLaw& law, const numbers::Interval& t);

/// The bounds together with one of |T'|, the speed at which the spine turns.
struct BandBounds {
  SecondDerivativeBounds second;
  double turning = 0;
};

/// See second_derivative_bounds().
[[nodiscard]] BandBounds band_bounds(const RingedSurface& surface, double from, double to);
/// The same on equal parts of [0, 1], one after the other, in about half the time.
[[nodiscard]] std::vector<BandBounds> band_bounds_of_cells(const RingedSurface& surface,
                                                           std::uint32_t cells);
[[nodiscard]] BandBounds band_bounds(const EllipticTube& tube, double from, double to);
/// Its frame is given, not carried: the bound of the turning is 0.
[[nodiscard]] BandBounds band_bounds(const RationalRingedSurface& surface, double from, double to);

}  // namespace dupin::ringed
