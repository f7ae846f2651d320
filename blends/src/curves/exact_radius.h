#pragma once

#include <optional>

#include "dupin/blends/radius_law.h"
#include "numbers/interval.h"
#include "numbers/polynomial.h"

namespace dupin::curves {

/// The law as an exact polynomial, if it is one.
[[nodiscard]] std::optional<numbers::Polynomial> polynomial(const RadiusLaw& law);

/// The radius at t with directed rounding (MPFI).
[[nodiscard]] numbers::Interval enclosed_radius(const CyclideRadius& law, double t);

/// An upper bound of |R''| on [0, 1].
[[nodiscard]] double second_derivative_bound(const CyclideRadius& law);

}  // namespace dupin::curves
