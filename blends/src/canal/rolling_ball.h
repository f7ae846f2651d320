#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

/// sqrt(gap + 2 d x^2) for gap >= 0: without a gap it is |x| times a constant.
template <class T>
[[nodiscard]] Jet<T> root_over_gap(double gap, double d, const Jet<T>& x, double sign) {
  if (gap == 0) {
    return sign * square_root(Jet<T>(2 * d)) * x;
  }
  return square_root(Jet<T>(gap) + 2 * d * square(x));
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingThrough& motion, const Turn<T>& turn) {
  const double d = motion.distance;
  const Jet<T> z = d * turn.sine - Jet<T>(motion.height);
  const Jet<T> y = motion.side *
                   root_over_gap(motion.below, d, turn.half_sine, turn.half_sine_sign) *
                   root_over_gap(motion.above, d, turn.half_cosine, turn.half_cosine_sign);
  const Jet<T> x = (d * turn.cosine + motion.cosine * y) / Jet<T>(motion.sine);
  return {combination<T>(motion.origin, {motion.along, motion.across, motion.up}, {x, y, z}),
          Jet<T>(motion.radius)};
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingPartly& motion, const Turn<T>& turn) {
  const double w = motion.overlap;
  const Jet<T> cosine_squared = square(turn.cosine), sine_squared = square(turn.sine);
  const Jet<T> root = square_root(Jet<T>(w));
  const Jet<T> z = w * sine_squared - Jet<T>(motion.distance);
  const Jet<T> y = root * turn.sine * square_root(Jet<T>(motion.first) + w * cosine_squared);
  const Jet<T> from_lower =
      root * turn.cosine * square_root(Jet<T>(motion.second) + w * sine_squared);
  const Jet<T> x = (from_lower + motion.cosine * y) / Jet<T>(motion.sine);
  return {combination<T>(motion.origin, {motion.along, motion.across, motion.up}, {x, y, z}),
          Jet<T>(motion.radius)};
}

}  // namespace dupin::canal
