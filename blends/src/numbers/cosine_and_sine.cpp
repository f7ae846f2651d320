#include "numbers/cosine_and_sine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dupin::numbers {
namespace {

/// An angle as a multiple of pi/2 and what is left, at most pi/4 and a little.
struct Reduced {
  long quarters;
  Interval rest;
};

/// x - quarters pi/2, whose products are exact: the first two parts of pi/2 have 33 bits each.
Interval less_quarters(double x, long quarters) {
  constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34;
  const Interval third(0x1.3198a2e037073p-69, 0x1.3198a2e037074p-69);
  const auto k = double(quarters);
  return Interval(x) - Interval(k * kFirst) - Interval(k * kSecond) - Interval(k) * third;
}

// The first terms of s/(n (n + 1)) - s^2/(n ... (n + 3)) + ..., s = x^2: with n = 1 it is
// 1 - cos x, with n = 2 1 - sin x / x.
template <int n>
double less_than_one(double s) {
  constexpr int kTerms = 8;
  static constexpr auto kCoefficients = [] {
    std::array<double, kTerms> result{};
    double factorial = 1;  // exact up to 18!
    for (int k = 0; k < kTerms; ++k) {
      factorial *= (n + 2 * k) * (n + 2 * k + 1);
      result[std::size_t(k)] = 1 / factorial;
    }
    return result;
  }();
  double sum = kCoefficients.back();
  for (int k = kTerms - 2; k >= 0; --k) {
    sum = kCoefficients[std::size_t(k)] - s * sum;
  }
  return s * sum;
}

// How far 1 less that is off cos x or sin x / x, for |x| < 0.8, with u = 2^-53: every bracket is a
// coefficient, off by u of itself, less at most a twelfth of it, whose error counts as little; so
// the last one is off by less than 2.5 u of itself, the whole, of at most 0.32, by 4.5 u of itself,
// and its difference from 1 by another u / 2: all in all less than 2 u. What is left out is less
// than the next term, 0.8^18 / 18! < u / 2^6.
constexpr double kOff = 0x1p-51;

CosineAndSine at(const Reduced& angle) {
  const auto [lower, upper] = angle.rest;
  const double x = lower + (upper - lower) / 2;
  // Neither function changes as fast as x, where |x| < 0.8: this rounding costs nothing.
  const double off = kOff + std::max(upper - x, x - lower);
  const double s = x * x, cosine_x = 1 - less_than_one<1>(s), ratio = 1 - less_than_one<2>(s);
  const Interval cosine = outward(cosine_x - off, cosine_x + off),
                 sine = angle.rest * outward(ratio - off, ratio + off);
  switch (angle.quarters & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

Reduced whole(double x) {
  const long quarters = std::lround(x / (std::numbers::pi / 2));
  return {quarters, less_quarters(x, quarters)};
}

// (x - pi/2) / 2 - m pi/2 = (x - (2 m + 1) pi/2) / 2.
Reduced half_beyond_quarter(double x) {
  const long m = std::lround(x / std::numbers::pi - 0.5);
  return {m, Interval(0.5) * less_quarters(x, 2 * m + 1)};
}

/// Whether `phase` plus a multiple of 2 pi may lie between; yes, where it does.
bool may_hold(double from, double to, double phase) {
  constexpr double kTurn = 2 * std::numbers::pi, kMargin = 1e-10;
  return std::ceil((from - kMargin - phase) / kTurn) * kTurn + phase <= to + kMargin;
}

Interval with_extremes(Interval ends, double from, double to, double phase_of_largest) {
  if (may_hold(from, to, phase_of_largest)) {
    ends.upper = 1;
  }
  if (may_hold(from, to, phase_of_largest + std::numbers::pi)) {
    ends.lower = -1;
  }
  return {std::max(ends.lower, -1.0), std::min(ends.upper, 1.0)};
}

// From the values at both ends, and approximations of the angles there.
template <class Reduction, class Angle>
CosineAndSine over(const Interval& x, const Reduction& reduced, const Angle& angle) {
  if (!(x.magnitude() <= 1000)) {
    return {Interval(-1, 1), Interval(-1, 1)};
  }
  CosineAndSine result = at(reduced(x.lower));
  if (x.lower < x.upper) {
    const CosineAndSine other = at(reduced(x.upper));
    result = {hull(result.cosine, other.cosine), hull(result.sine, other.sine)};
  }
  const double from = angle(x.lower), to = angle(x.upper);
  return {with_extremes(result.cosine, from, to, 0),
          with_extremes(result.sine, from, to, std::numbers::pi / 2)};
}

}  // namespace

CosineAndSine cosine_and_sine(const Interval& x) {
  return over(x, whole, [](double end) { return end; });
}

CosineAndSine cosine_and_sine_of_half_beyond_quarter(const Interval& x) {
  return over(x, half_beyond_quarter, [](double end) { return (end - std::numbers::pi / 2) / 2; });
}

}  // namespace dupin::numbers
