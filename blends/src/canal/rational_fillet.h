#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

/// The function g that sets the size of the balls.
template <class T>
[[nodiscard]] T size_jet(const std::array<double, 4>& size, const Turn<T>& turn) {
  const T twice = 2 * square(turn.cosine) - T(1);
  return T(size[0]) + size[1] * turn.cosine + size[2] * turn.sine + size[3] * twice;
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RationalCrossing& motion, const Turn<T>& turn) {
  const double d = motion.distance;
  const T g = size_jet(motion.size, turn);
  const T p = g * turn.sine, squared = square(p);
  const T n = T(1) + squared - 2 * g;
  const T y = (motion.side * d) * ((T(1) - squared) / n);
  const T x = ((2 * d) * (g * turn.cosine / n) + motion.cosine * y) / T(motion.sine);
  return ball_at<T, 4>(motion.origin, {motion.along, motion.across, motion.e3, motion.e4},
                       {x, y, (2 * d) * (p / n), -d * ((T(1) + squared) / n)});
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RationalParallel& motion, const Turn<T>& turn) {
  const double h = motion.half_distance;
  const T one(1);
  const T a = motion.far_squared / 2 * (one + turn.cosine);
  const T b = motion.near_squared / 2 * (one - turn.cosine);
  const T root = square_root(T(motion.far_squared)) * square_root(T(motion.near_squared));
  const T u = (one + a) / (one - a), v = (one - b) / (one + b);
  const T z = (2 * h) * (root * turn.sine / ((one - a) * (one + b)));
  const T w1 = -h * (u - v), w2 = -h * (u + v);
  const T k(motion.product), rest = one - square(k);
  return ball_at<T, 4>(motion.origin, {motion.ey, motion.ez, motion.nu1, motion.nu2},
                       {h * (u * v), z, (w1 + k * w2) / rest, (w2 + k * w1) / rest});
}

}  // namespace dupin::canal
