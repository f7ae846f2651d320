#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/end.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "numbers/interval.h"

namespace dupin::surfaces {

/// A disc over a stretch of its parameter: where it is and how it moves, in intervals.
struct MovingDisc {
  numbers::IntervalVec center, normal;     ///< unit normal
  numbers::IntervalVec velocity, turning;  ///< the derivatives of both
  numbers::Interval radius;
};

/// Over the interval t within [0, 1]; none where the numbers do not tell that the disc moves. With
/// `steered`, both derivatives are divided by the same positive function, so that they do not
/// vanish where the disc comes to rest at an end.
[[nodiscard]] std::optional<MovingDisc> moving_disc(const RationalRingedSurface& surface,
                                                    const numbers::Interval& t, bool steered);

/// How far discs move along and across their normals, and turn: all per unit of the parameter or of
/// something that it grows with.
struct DiscPace {
  double advance = 0, sideways = 0, turning = 0;  ///< the first from below, the others from above
  numbers::Interval radius;
  double width = 0;  ///< of the stretch
};

[[nodiscard]] DiscPace pace(const MovingDisc& disc, double width);

/// Whether discs on the way through these stretches, one after the other, do not come back: their
/// normals turn by at most phi < 1 in all, and advance cos phi - sideways sin phi exceeds the
/// largest radius times the turning (docs/certificate_format.md).
[[nodiscard]] bool advances(const std::vector<DiscPace>& way);

}  // namespace dupin::surfaces
