#include "numbers/cosine_and_sine.h"

#include <algorithm>
#include <cmath>
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

// 1 - s/a (1 - s/b (1 - ...)) with a = n (n + 1), b = (n + 2) (n + 3), ...: of s in [0, 1] every
// bracket lies in [0, 1], and so does the one that is left out. Nothing is negative, so that ends
// come of ends, which is three times as fast as products of any signs.
Interval alternating(const Interval& s, int n) {
  constexpr int kTerms = 10;
  const double least = std::max(s.lower, 0.0);
  Interval bracket(0, 1);
  for (int i = n + 2 * (kTerms - 1); i >= n; i -= 2) {
    const double a = i * (i + 1);
    const Interval term = outward(least / a, s.upper / a);
    const Interval rest = outward(std::max(term.lower, 0.0) * std::max(bracket.lower, 0.0),
                                  term.upper * bracket.upper);
    bracket = outward(1 - rest.upper, 1 - rest.lower);
  }
  return bracket;
}

CosineAndSine at(const Reduced& angle) {
  const Interval s = square(angle.rest);
  const Interval cosine = alternating(s, 1), sine = angle.rest * alternating(s, 2);
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
