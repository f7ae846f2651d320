#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "canal/series.h"

namespace dupin::canal {

/// Taylor coefficients over a stretch, and at a place in it: after every operation the former are
/// what Taylor's formula with the latter allows, as far as that is less. Intervals take what
/// depends on the parameter in two ways for independent; with n coefficients that costs the n-th
/// power of the stretch's length only.
template <std::size_t n>
struct CenteredSeries {
  Series<n> middle, all;
  numbers::Interval offsets = 0;  ///< of the stretch's places from the middle one

  CenteredSeries() = default;
  CenteredSeries(double constant) : middle(constant), all(constant) {}
  CenteredSeries(const Series<n>& at_middle, const Series<n>& at_all,
                 const numbers::Interval& places)
      : middle(at_middle), all(at_all), offsets(places) {
    if (offsets.lower < 0 || offsets.upper > 0) {
      tighten();
    }
  }

  friend CenteredSeries operator+(const CenteredSeries& a, const CenteredSeries& b) {
    return {a.middle + b.middle, a.all + b.all, hull(a.offsets, b.offsets)};
  }
  friend CenteredSeries operator-(const CenteredSeries& a, const CenteredSeries& b) {
    return {a.middle - b.middle, a.all - b.all, hull(a.offsets, b.offsets)};
  }
  friend CenteredSeries operator-(const CenteredSeries& a) { return CenteredSeries(0.0) - a; }
  friend CenteredSeries operator*(const CenteredSeries& a, const CenteredSeries& b) {
    return {a.middle * b.middle, a.all * b.all, hull(a.offsets, b.offsets)};
  }
  friend CenteredSeries operator*(double s, const CenteredSeries& a) {
    return {s * a.middle, s * a.all, a.offsets};
  }
  friend CenteredSeries operator/(const CenteredSeries& a, const CenteredSeries& b) {
    return {a.middle / b.middle, a.all / b.all, hull(a.offsets, b.offsets)};
  }
  /// Of a positive function.
  friend CenteredSeries square_root(const CenteredSeries& a) {
    return {square_root(a.middle), square_root(a.all), a.offsets};
  }
  friend CenteredSeries square(const CenteredSeries& a) {
    return {square(a.middle), square(a.all), a.offsets};
  }

 private:
  static constexpr std::array<std::array<double, n>, n> binomials() {
    std::array<std::array<double, n>, n> result{};
    for (std::size_t j = 0; j < n; ++j) {
      result[j][0] = 1;
      for (std::size_t k = 1; k <= j; ++k) {
        result[j][k] = result[j][k - 1] * double(j + 1 - k) / double(k);
      }
    }
    return result;
  }

  // In doubles, as this is done after every operation: terms of one sign are summed up, so that
  // the sum is off by a share of itself, or by less than the least normal double.
  void tighten() {
    static_assert(n <= 16);
    constexpr double kRounding = 0x1p-46;  // of 3 n operations, of 2^-53 each
    constexpr double kUnderflow = std::numeric_limits<double>::min();
    static constexpr auto kBinomial = binomials();
    std::array<double, n> powers;
    powers[0] = 1;
    for (std::size_t k = 1; k < n; ++k) {
      powers[k] = std::max(powers[k - 1] * offsets.magnitude(), kUnderflow);  // no less than it is
    }
    // The last one is what it is.
    for (std::size_t k = 0; k + 1 < n; ++k) {
      double below = 0, above = 0;
      for (std::size_t j = k + 1; j < n; ++j) {
        const numbers::Interval& own = (j + 1 < n ? middle : all).at[j];
        const bool is_even = (j - k) % 2 == 0;
        const double factor = kBinomial[j][k] * powers[j - k];
        below += factor * (is_even ? std::max(0.0, -own.lower) : own.magnitude());
        above += factor * (is_even ? std::max(0.0, own.upper) : own.magnitude());
      }
      const auto enlarged = [](double sum) { return sum + sum * kRounding + kUnderflow; };
      all.at[k] = numbers::intersection(
          middle.at[k] + numbers::Interval(-enlarged(below), enlarged(above)), all.at[k]);
    }
  }
};

template <std::size_t n>
[[nodiscard]] CenteredSeries<n - 1> derivative(const CenteredSeries<n>& a) {
  return {derivative(a.middle), derivative(a.all), a.offsets};
}

template <std::size_t n>
[[nodiscard]] CenteredSeries<n - 1> shortened(const CenteredSeries<n>& a) {
  return {shortened(a.middle), shortened(a.all), a.offsets};
}

}  // namespace dupin::canal
