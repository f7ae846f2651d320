#pragma once

#include "dupin/blends/rational_ringed_surface.h"

namespace dupin {

/// Whether rho > 0 and rho |n'| < (1 - margin) d'.n on [0, 1], decided by Bernstein subdivision of
/// the exact polynomials; false also where that does not decide within 40 halvings. At an end where
/// the circle stands still and its radius alone moves, as it does out of a plate, the inequality
/// holds in the limit.
[[nodiscard]] bool proves_regular(const RationalRingedSurface& surface, double margin = 0);

/// The largest multiple of 1/256 that is a proven lower bound of min(1 - rho |n'| / d'.n), which
/// for normal ringed surfaces is min(1 - kappa R). 0 for what is regular, but barely.
[[nodiscard]] double certified_margin(const RationalRingedSurface& surface);

}  // namespace dupin
