#pragma once

#include "canal/moving_ball.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

/// sqrt(gap + 2 d x^2) for gap >= 0: without a gap it is |x| times a constant.
template <class T>
[[nodiscard]] T root_over_gap(double gap, double d, const T& x, double sign) {
  if (gap == 0) {
    return sign * square_root(T(2 * d)) * x;
  }
  return square_root(T(gap) + 2 * d * square(x));
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingThrough& motion, const Turn<T>& turn) {
  const double d = motion.distance;
  const T z = d * turn.sine - T(motion.height);
  const T y = motion.side * root_over_gap(motion.below, d, turn.half_sine, turn.half_sine_sign) *
              root_over_gap(motion.above, d, turn.half_cosine, turn.half_cosine_sign);
  const T x = (d * turn.cosine + motion.cosine * y) / T(motion.sine);
  return {combination<T>(motion.origin, {motion.along, motion.across, motion.up}, {x, y, z}),
          T(motion.radius)};
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingPartly& motion, const Turn<T>& turn) {
  const double w = motion.overlap;
  const T cosine_squared = square(turn.cosine), sine_squared = square(turn.sine);
  const T root = square_root(T(w));
  const T z = w * sine_squared - T(motion.distance);
  const T y = root * turn.sine * square_root(T(motion.first) + w * cosine_squared);
  const T from_lower = root * turn.cosine * square_root(T(motion.second) + w * sine_squared);
  const T x = (from_lower + motion.cosine * y) / T(motion.sine);
  return {combination<T>(motion.origin, {motion.along, motion.across, motion.up}, {x, y, z}),
          T(motion.radius)};
}

template <class T>
[[nodiscard]] T product(const JetVec<T>& a, const JetVec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
[[nodiscard]] T product(const JetVec<T>& a, const Vec3& b) {
  return b[0] * a[0] + b[1] * a[1] + b[2] * a[2];
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingOnCones& motion, const Turn<T>& turn) {
  // The generator start + t ahead, where |w|^2 - (w.n)^2 = (radius + slope w.n)^2 from the first.
  const Ring &one = motion.first, &two = motion.second;
  const auto around = [&](const Vec3& origin, const Vec3& along, double size) {
    return combination<T>(origin, {size * motion.zero, size * motion.quarter, along},
                          {turn.cosine, turn.sine, T(1)});
  };
  const JetVec<T> start = around(two.center - one.center, Vec3::Zero(), two.radius);
  const JetVec<T> ahead = around(Vec3::Zero(), two.normal, two.slope);
  const T s0 = product<T>(start, one.normal), s1 = product<T>(ahead, one.normal);
  const double stretch = 1 + one.slope * one.slope, lever = one.radius * one.slope;
  const T a = product<T>(ahead, ahead) - stretch * square(s1);
  const T b = product<T>(start, ahead) - stretch * (s0 * s1) - lever * s1;
  const T c =
      product<T>(start, start) - stretch * square(s0) - 2 * lever * s0 - T(one.radius * one.radius);
  const T t = (motion.side * square_root(square(b) - a * c) - b) / a;
  BallJet<T> result;
  result.radius = motion.radius;
  for (std::size_t k = 0; k < 3; ++k) {
    result.center[k] = T(one.center[static_cast<int>(k)]) + start[k] + t * ahead[k];
  }
  return result;
}

template <class T>
[[nodiscard]] BallJet<T> ball_jet(const RollingPartlyOnCones& motion, const Turn<T>& turn) {
  // As for RollingOnCones, with the direction of the angle's double tangent times 1 + q^2.
  const Ring &one = motion.first, &two = motion.second;
  const T q = motion.width * turn.cosine, all = T(1) + square(q);
  const T zero = T(1) - square(q), quarter = 2 * q;
  const auto around = [&](const Vec3& along, double size) {
    return combination<T>(Vec3::Zero(), {size * motion.zero, size * motion.quarter, along},
                          {zero, quarter, all});
  };
  const JetVec<T> start = around(two.center - one.center, two.radius);
  const JetVec<T> ahead = around(two.normal, two.slope);
  const T s0 = product<T>(start, one.normal), s1 = product<T>(ahead, one.normal);
  const double stretch = 1 + one.slope * one.slope, lever = one.radius * one.slope;
  const T a = product<T>(ahead, ahead) - stretch * square(s1);
  const T b = product<T>(start, ahead) - stretch * (s0 * s1) - lever * (s1 * all);
  T rest(motion.rest.back());
  for (std::size_t i = motion.rest.size() - 1; i-- > 0;) {
    rest = rest * turn.cosine + T(motion.rest[i]);
  }
  const T t = (turn.sine * square_root(rest) - b) / a;
  BallJet<T> result;
  result.radius = motion.radius;
  for (std::size_t k = 0; k < 3; ++k) {
    result.center[k] = T(one.center[static_cast<int>(k)]) + (start[k] + t * ahead[k]) / all;
  }
  return result;
}

}  // namespace dupin::canal
