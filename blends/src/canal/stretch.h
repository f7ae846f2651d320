#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"
#include "numbers/interval.h"

namespace dupin::canal {

/// What motions are made of, over a stretch of the parameter. The signs are those in its middle.
[[nodiscard]] Turn<numbers::Interval> turn(double from, double to);

/// The balls of a stretch.
[[nodiscard]] BallJet<numbers::Interval> balls(const CanalFillet& fillet, double from, double to);

}  // namespace dupin::canal
