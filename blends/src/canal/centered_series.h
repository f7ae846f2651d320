#pragma once

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
  void tighten() {
    std::array<numbers::Interval, n> powers;
    powers[0] = 1;
    for (std::size_t k = 1; k < n; ++k) {
      powers[k] = k % 2 == 0 ? numbers::square(powers[k / 2]) : powers[k - 1] * offsets;
    }
    // The last one is what it is.
    for (std::size_t k = 0; k + 1 < n; ++k) {
      numbers::Interval sum = 0;
      double binomial = 1;  // of j and k
      for (std::size_t j = k; j < n; ++j) {
        sum = sum + numbers::Interval(binomial) * (j + 1 < n ? middle : all).at[j] * powers[j - k];
        binomial = binomial * double(j + 1) / double(j + 1 - k);
      }
      numbers::Interval& own = all.at[k];
      own = {std::max(sum.lower, own.lower), std::min(sum.upper, own.upper)};
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
