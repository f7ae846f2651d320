#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"
#include "numbers/interval.h"

namespace dupin::canal {

/// What motions are made of, on all of the interval, up to the double after it: there is no gap to
/// the next one that begins with this one's end. It holds at most one of the parameters pi/2 and
/// -pi/2 (with the period 2 pi), at an end.
[[nodiscard]] Turn<numbers::Interval> turn(const ParameterInterval& at);

/// The balls there.
[[nodiscard]] BallJet<numbers::Interval> balls(const CanalFillet& fillet,
                                               const ParameterInterval& at);

}  // namespace dupin::canal
