#pragma once

#include <array>

namespace dupin::exact {

/// Of vectors in numbers of any kind: exact ones, intervals, balls.
template <class N>
[[nodiscard]] std::array<N, 3> difference(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
[[nodiscard]] std::array<N, 3> cross(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class N>
[[nodiscard]] N dot(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From a point in homogeneous coordinates to another one, times their weights.
template <class N>
[[nodiscard]] std::array<N, 3> direction(const std::array<N, 4>& from, const std::array<N, 4>& to) {
  return {to[0] * from[3] - from[0] * to[3], to[1] * from[3] - from[1] * to[3],
          to[2] * from[3] - from[2] * to[3]};
}

}  // namespace dupin::exact
