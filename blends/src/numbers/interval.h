#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dupin/kernel/vec.h"

namespace dupin::numbers {

/// A closed interval of reals, ends rounded outwards after every operation: whatever real numbers
/// the operands stand for, the result holds the operation's exact value.
struct Interval {
  double lower = 0, upper = 0;

  Interval() = default;
  Interval(double value) : lower(value), upper(value) {}  // numbers are intervals
  Interval(double low, double high) : lower(low), upper(high) {}

  /// The largest absolute value in it.
  [[nodiscard]] double magnitude() const { return std::max(std::abs(lower), std::abs(upper)); }
};

/// The next smaller double; std::nextafter is a call. Doubles of one sign are ordered as their
/// bits.
inline double next_below(double x) {
  if (!(x > -std::numeric_limits<double>::infinity())) {
    return x;
  }
  if (x == 0) {
    return -std::numeric_limits<double>::denorm_min();
  }
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits - 1 : bits + 1);
}

/// One ulp outwards on both sides: what one correctly rounded operation may have lost.
inline Interval outward(double low, double high) { return {next_below(low), -next_below(-high)}; }

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }

inline Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.lower + b.lower, a.upper + b.upper);
}

inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

inline Interval operator*(const Interval& a, const Interval& b) {
  const auto [low, high] =
      std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
  return outward(low, high);
}

/// Requires b > 0.
inline Interval operator/(const Interval& a, const Interval& b) {
  const auto [low, high] =
      std::minmax({a.lower / b.lower, a.lower / b.upper, a.upper / b.lower, a.upper / b.upper});
  return outward(low, high);
}

inline Interval square(const Interval& a) {
  const double high = a.magnitude();
  const double low = a.lower > 0 ? a.lower : (a.upper < 0 ? -a.upper : 0);
  const Interval product = outward(low * low, high * high);
  return {std::max(product.lower, 0.0), product.upper};
}

/// The root of the part of it that is not negative.
inline Interval sqrt(const Interval& a) {
  const Interval root = outward(std::sqrt(std::max(a.lower, 0.0)), std::sqrt(a.upper));
  return {std::max(root.lower, 0.0), root.upper};
}

using IntervalVec = std::array<Interval, 3>;

inline IntervalVec interval_vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

inline IntervalVec operator+(const IntervalVec& a, const IntervalVec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline IntervalVec operator-(const IntervalVec& a, const IntervalVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline IntervalVec operator*(const Interval& s, const IntervalVec& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

inline Interval dot(const IntervalVec& a, const IntervalVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Interval norm(const IntervalVec& a) {
  return sqrt(square(a[0]) + square(a[1]) + square(a[2]));
}

inline IntervalVec cross(const IntervalVec& a, const IntervalVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace dupin::numbers
