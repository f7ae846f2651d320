#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "canal/moving_ball.h"
#include "numbers/interval.h"

namespace dupin::canal {

/// Enclosures of the first Taylor coefficients f, f', f''/2, ... of a function.
template <std::size_t n>
struct Series {
  std::array<numbers::Interval, n> at{};

  Series() = default;
  Series(double constant) { at[0] = constant; }  // numbers are constant functions
  explicit Series(const numbers::Interval& constant) { at[0] = constant; }

  friend Series operator+(const Series& a, const Series& b) {
    Series result;
    for (std::size_t k = 0; k < n; ++k) {
      result.at[k] = a.at[k] + b.at[k];
    }
    return result;
  }
  friend Series operator-(const Series& a, const Series& b) {
    Series result;
    for (std::size_t k = 0; k < n; ++k) {
      result.at[k] = a.at[k] - b.at[k];
    }
    return result;
  }
  friend Series operator-(const Series& a) { return Series(0.0) - a; }
  friend Series operator*(const Series& a, const Series& b) {
    Series result;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j <= k; ++j) {
        result.at[k] = result.at[k] + a.at[j] * b.at[k - j];
      }
    }
    return result;
  }
  friend Series operator*(double s, const Series& a) {
    Series result;
    for (std::size_t k = 0; k < n; ++k) {
      result.at[k] = numbers::Interval(s) * a.at[k];
    }
    return result;
  }
  friend Series operator/(const Series& a, const Series& b) {
    Series result;
    for (std::size_t k = 0; k < n; ++k) {
      numbers::Interval rest = a.at[k];
      for (std::size_t j = 0; j < k; ++j) {
        rest = rest - result.at[j] * b.at[k - j];
      }
      result.at[k] = rest / b.at[0];
    }
    return result;
  }
  /// Of a positive function.
  friend Series square_root(const Series& a) {
    Series result;
    result.at[0] = numbers::sqrt(a.at[0]);
    for (std::size_t k = 1; k < n; ++k) {
      numbers::Interval rest = a.at[k];
      for (std::size_t j = 1; j < k; ++j) {
        rest = rest - result.at[j] * result.at[k - j];
      }
      result.at[k] = rest / (numbers::Interval(2) * result.at[0]);
    }
    return result;
  }
  friend Series square(const Series& a) {
    Series result = a * a;
    result.at[0] = numbers::square(a.at[0]);
    return result;
  }
};

/// The derivative, of which one coefficient less is known.
template <std::size_t n>
[[nodiscard]] Series<n - 1> derivative(const Series<n>& a) {
  Series<n - 1> result;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    result.at[k] = numbers::Interval(double(k + 1)) * a.at[k + 1];
  }
  return result;
}

template <std::size_t n>
[[nodiscard]] Series<n - 1> shortened(const Series<n>& a) {
  Series<n - 1> result;
  std::copy_n(a.at.begin(), n - 1, result.at.begin());
  return result;
}

/// Of a wave of this frequency that has this value, and this derivative divided by the frequency.
template <std::size_t n>
[[nodiscard]] Series<n> wave(const numbers::Interval& value, const numbers::Interval& rate,
                             double frequency) {
  Series<n> result;
  numbers::Interval factor = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const numbers::Interval& known = k % 2 == 0 ? value : rate;
    result.at[k] = factor * (k % 4 < 2 ? known : -known);
    factor = factor * frequency / numbers::Interval(double(k + 1));
  }
  return result;
}

}  // namespace dupin::canal
