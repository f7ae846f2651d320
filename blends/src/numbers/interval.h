#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "dupin/kernel/vec.h"

// The numbers that geometry is decided with, from the cheapest to the dearest: intervals of doubles
// (here), intervals of MPFI with as many bits as asked for (mpfi_interval.h), and rationals
// (exact_vec3.h, polynomial.h). An interval [a, b] stands for some real number in it, and every
// operation returns an interval that holds the result for all numbers that its operands may stand
// for; what is proven of intervals is proven of the numbers. Polynomials come in powers, lowest
// first, or in Bernstein form on an interval, whose coefficients enclose the values there
// (polynomial.h exactly, bezier.h in intervals): signs of coefficients prove signs of functions,
// by halving the interval until they do.
namespace dupin::numbers {

/// A closed interval of reals, ends rounded outwards after every operation: whatever real numbers
/// the operands stand for, the result holds the operation's exact value.
///
/// It is total: infinite ends stand for no bound, and what has no result, or no order of its ends,
/// is the whole line. No operation makes a NaN, so that a comparison with an end never passes, or
/// is passed over, because of one: `lower` is never +infinity, and `upper` never -infinity.
struct Interval {
  double lower = 0, upper = 0;

  Interval() = default;
  Interval(double value) : Interval(value, value) {}  // numbers are intervals
  Interval(double low, double high) : lower(low), upper(high) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    if (!(low <= high)) {
      *this = whole();
    } else if (low > kLargest) {
      lower = kLargest;
    } else if (high < -kLargest) {
      upper = -kLargest;
    }
  }

  /// All reals.
  [[nodiscard]] static Interval whole() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity};
  }

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

/// The next larger double.
inline double next_above(double x) { return -next_below(-x); }

/// One ulp outwards on both sides: what one correctly rounded operation may have lost.
inline Interval outward(double low, double high) { return {next_below(low), next_above(high)}; }

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// What both hold, of two that hold the same number; the whole line if there is none.
inline Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }

/// Exactly 0. What is, stays so in products, and sums that are 0 are exact: an ulp of 0 is
/// subnormal, and processors take a hundred times as long for these.
inline bool is_zero(const Interval& a) { return a.lower == 0 && a.upper == 0; }

inline Interval operator+(const Interval& a, const Interval& b) {
  const double low = a.lower + b.lower, high = a.upper + b.upper;
  return {low == 0 ? 0 : next_below(low), high == 0 ? 0 : next_above(high)};
}

inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

/// What holds four numbers; the whole line if one of them is none, as 0 times infinity is.
inline Interval around(double a, double b, double c, double d) {
  if (std::isnan(a) || std::isnan(b) || std::isnan(c) || std::isnan(d)) {
    return Interval::whole();
  }
  return outward(std::min(std::min(a, b), std::min(c, d)),
                 std::max(std::max(a, b), std::max(c, d)));
}

inline Interval operator*(const Interval& a, const Interval& b) {
  if ((is_zero(a) && std::isfinite(b.lower) && std::isfinite(b.upper)) ||
      (is_zero(b) && std::isfinite(a.lower) && std::isfinite(a.upper))) {
    return 0;
  }
  return around(a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper);
}

/// By the numbers of a divisor that are not 0; the whole line where 0 is inside it, or all of it.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.lower < 0 && b.upper <= 0) {
    return -(a / -b);
  }
  if (is_zero(a) && b.lower > 0 && std::isfinite(b.upper)) {
    return 0;
  }
  const double least = b.lower + 0.0;  // -0 would have the other sign of infinity
  return least >= 0 && b.upper > 0
             ? around(a.lower / least, a.lower / b.upper, a.upper / least, a.upper / b.upper)
             : Interval::whole();
}

/// Holds the larger of two numbers.
inline Interval max(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// Holds the smaller of two numbers.
inline Interval min(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}

inline Interval square(const Interval& a) {
  const double high = a.magnitude();
  const double low = a.lower > 0 ? a.lower : (a.upper < 0 ? -a.upper : 0);
  const Interval product = high == 0 ? Interval(0) : outward(low * low, high * high);
  return {std::max(product.lower, 0.0), product.upper};
}

/// The root of the part of it that is not negative; the whole line if there is none.
inline Interval sqrt(const Interval& a) {
  if (a.upper <= 0) {
    return a.upper < 0 ? Interval::whole() : Interval(0);
  }
  const Interval root = outward(std::sqrt(std::max(a.lower, 0.0)), std::sqrt(a.upper));
  return {std::max(root.lower, 0.0), root.upper};
}

using IntervalVec = std::array<Interval, 3>;

inline IntervalVec interval_vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

inline double middle(const Interval& a) { return std::midpoint(a.lower, a.upper); }

inline Vec3 middle(const IntervalVec& v) { return {middle(v[0]), middle(v[1]), middle(v[2])}; }

inline IntervalVec operator+(const IntervalVec& a, const IntervalVec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline IntervalVec operator-(const IntervalVec& a, const IntervalVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline IntervalVec operator*(const Interval& s, const IntervalVec& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

inline IntervalVec intersection(const IntervalVec& a, const IntervalVec& b) {
  return {intersection(a[0], b[0]), intersection(a[1], b[1]), intersection(a[2], b[2])};
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
