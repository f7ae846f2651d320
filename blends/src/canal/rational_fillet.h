#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

/// The function g that sets the size of the balls.
template <class T>
[[nodiscard]] Jet<T> size_jet(const std::array<double, 4>& size, const Turn<T>& turn) {
  const Jet<T> twice = 2 * square(turn.cosine) - Jet<T>(1);
  return Jet<T>(size[0]) + size[1] * turn.cosine + size[2] * turn.sine + size[3] * twice;
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RationalCrossing& motion, const Turn<T>& turn) {
  const double d = motion.distance;
  const Jet<T> g = size_jet(motion.size, turn);
  const Jet<T> p = g * turn.sine, squared = square(p);
  const Jet<T> n = Jet<T>(1) + squared - 2 * g;
  const Jet<T> y = (motion.side * d) * ((Jet<T>(1) - squared) / n);
  const Jet<T> x = ((2 * d) * (g * turn.cosine / n) + motion.cosine * y) / Jet<T>(motion.sine);
  return ball_at<T, 4>(motion.origin, {motion.along, motion.across, motion.e3, motion.e4},
                       {x, y, (2 * d) * (p / n), -d * ((Jet<T>(1) + squared) / n)});
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RationalParallel& motion, const Turn<T>& turn) {
  const double h = motion.half_distance;
  const Jet<T> one(1);
  const Jet<T> a = motion.far_squared / 2 * (one + turn.cosine);
  const Jet<T> b = motion.near_squared / 2 * (one - turn.cosine);
  const Jet<T> root =
      square_root(Jet<T>(motion.far_squared)) * square_root(Jet<T>(motion.near_squared));
  const Jet<T> u = (one + a) / (one - a), v = (one - b) / (one + b);
  const Jet<T> z = (2 * h) * (root * turn.sine / ((one - a) * (one + b)));
  const Jet<T> w1 = -h * (u - v), w2 = -h * (u + v);
  const Jet<T> k(motion.product), rest = one - square(k);
  return ball_at<T, 4>(motion.origin, {motion.ey, motion.ez, motion.nu1, motion.nu2},
                       {h * (u * v), z, (w1 + k * w2) / rest, (w2 + k * w1) / rest});
}

}  // namespace dupin::canal
