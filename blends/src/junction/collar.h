#pragma once

#include <vector>

#include "dupin/blends/pe_arc.h"

namespace dupin::junction {

/// How far along its own cone a pipe has to go on before its collar begins, so that this ends in a
/// cap of the given angular radius; negative: back. At most two, the largest first.
///
/// With D = hub - from = (o - m; R - r), g = cot(cap) + tau: the s with 2 (<D, T> - s)((R - r) - s
/// tau) = g (<D, D> - 2 s <D, T> + s^2). For cylinders on the way to the centre at the distance h,
/// h - s = (R - r) / tan(45 degrees - cap / 2).
[[nodiscard]] std::vector<double> slides(const PeVector& from, const PeVector& tangent,
                                         const PeVector& hub, double cap_angle);

/// The angular radius of the cap in which the collar ends, for a valid one.
[[nodiscard]] double cap_angle(const PeVector& from, const PeVector& tangent, const PeVector& hub);

/// What two caps in directions so far apart may have, so that each is as wide as its pipe is thick
/// and there is a gap between them: the first one's angular radius, at most `widest`.
[[nodiscard]] double cap_share(double between, double thickness, double other_thickness,
                               double widest);

}  // namespace dupin::junction
