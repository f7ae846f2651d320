#pragma once

#include <array>

namespace dupin::numbers {

/// Hamilton quaternions (w, x, y, z) over any numbers.
template <class Number>
using Quaternion = std::array<Number, 4>;

template <class Number>
[[nodiscard]] Quaternion<Number> product(const Quaternion<Number>& a, const Quaternion<Number>& b) {
  return {Number(a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3]),
          Number(a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2]),
          Number(a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1]),
          Number(a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])};
}

template <class Number>
[[nodiscard]] Quaternion<Number> conjugate(const Quaternion<Number>& a) {
  return {a[0], Number(-a[1]), Number(-a[2]), Number(-a[3])};
}

}  // namespace dupin::numbers
