#pragma once

#include <array>
#include <cmath>

#include "numbers/interval.h"

namespace dupin::canal {

/// A function's value and first two derivatives at a parameter, of numbers or of intervals.
template <class T>
struct Jet {
  T value = 0, rate = 0, acceleration = 0;

  Jet() = default;
  Jet(double constant) : value(constant) {}  // numbers are constant functions
  Jet(const T& v, const T& r, const T& a) : value(v), rate(r), acceleration(a) {}

  friend Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.rate + b.rate, a.acceleration + b.acceleration};
  }
  friend Jet operator-(const Jet& a, const Jet& b) {
    return {a.value - b.value, a.rate - b.rate, a.acceleration - b.acceleration};
  }
  friend Jet operator-(const Jet& a) { return {-a.value, -a.rate, -a.acceleration}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate,
            a.acceleration * b.value + T(2) * a.rate * b.rate + a.value * b.acceleration};
  }
  friend Jet operator*(double s, const Jet& a) {
    return {T(s) * a.value, T(s) * a.rate, T(s) * a.acceleration};
  }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const T quotient = a.value / b.value;
    const T change = (a.rate - quotient * b.rate) / b.value;
    return {quotient, change,
            (a.acceleration - T(2) * change * b.rate - quotient * b.acceleration) / b.value};
  }
  /// Of a positive function.
  friend Jet square_root(const Jet& a) {
    using numbers::sqrt;
    using std::sqrt;
    const T root = sqrt(a.value);
    const T change = a.rate / (T(2) * root);
    return {root, change, (a.acceleration / T(2) - change * change) / root};
  }
};

template <class T>
[[nodiscard]] Jet<T> square(const Jet<T>& a) {
  using numbers::square;
  const auto squared = [](const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      return x * x;
    } else {
      return square(x);
    }
  };
  return {squared(a.value), T(2) * a.value * a.rate,
          T(2) * (squared(a.rate) + a.value * a.acceleration)};
}

}  // namespace dupin::canal
