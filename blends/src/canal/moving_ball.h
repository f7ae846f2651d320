#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "canal/jet.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/vec.h"

namespace dupin::canal {

/// Of functions, which are jets or series (series.h).
template <class T>
using JetVec = std::array<T, 3>;

template <class T>
[[nodiscard]] JetVec<T> combination(const Vec3& origin, const std::array<Vec3, 3>& axes,
                                    const JetVec<T>& coordinates) {
  JetVec<T> result;
  for (int k = 0; k < 3; ++k) {
    result[static_cast<std::size_t>(k)] = T(origin[k]) + axes[0][k] * coordinates[0] +
                                          axes[1][k] * coordinates[1] + axes[2][k] * coordinates[2];
  }
  return result;
}

/// A moving ball.
template <class T>
struct BallJet {
  JetVec<T> center;
  T radius;
};

/// The ball that is the point `origin` plus a combination of vectors in R^{3,1}: its last
/// coordinate is minus the radius.
template <class T, std::size_t n>
[[nodiscard]] BallJet<T> ball_at(const PeVector& origin, const std::array<PeVector, n>& axes,
                                 const std::array<T, n>& coordinates) {
  BallJet<T> result;
  for (int k = 0; k < 3; ++k) {
    T& coordinate = result.center[static_cast<std::size_t>(k)];
    coordinate = origin.m[k];
    for (std::size_t i = 0; i < n; ++i) {
      coordinate = coordinate + axes[i].m[k] * coordinates[i];
    }
  }
  result.radius = -origin.r;
  for (std::size_t i = 0; i < n; ++i) {
    result.radius = result.radius - axes[i].r * coordinates[i];
  }
  return result;
}

/// What motions are made of: functions of the parameter.
template <class T>
struct Turn {
  T cosine, sine;
  /// Of half the angle by which it is beyond pi/2: sine = 1 - 2 half_sine^2 = 2 half_cosine^2 - 1,
  /// without cancellation where it is near 1 or -1.
  T half_cosine, half_sine;
  /// 1 or -1: the signs of the latter two, on a stretch of one sign each.
  double half_cosine_sign = 1, half_sine_sign = 1;
};

[[nodiscard]] inline Turn<Jet<double>> turn(double parameter) {
  const double c = std::cos(parameter), s = std::sin(parameter);
  const double half = (parameter - std::numbers::pi / 2) / 2;
  const double p = std::cos(half), q = std::sin(half);
  return {{c, -s, -c},        {s, c, -s},         {p, -q / 2, -p / 4},
          {q, p / 2, -q / 4}, p < 0 ? -1.0 : 1.0, q < 0 ? -1.0 : 1.0};
}

}  // namespace dupin::canal
