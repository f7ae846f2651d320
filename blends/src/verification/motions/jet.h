#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numbers/interval.h"
#include "numbers/mpfi_interval.h"
#include "verification/work.h"

namespace dupin::verification {

using numbers::Interval;
using numbers::IntervalVec;
using Mpfi = numbers::MpfiInterval<128>;

/// The interval of doubles around it.
[[nodiscard]] inline Interval narrowed(const Mpfi& x) {
  spend(8);  // on sines, cosines and angles
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

/// Encloses a function's value and first derivatives over a stretch of the parameter.
template <std::size_t count>
struct Jet {
  std::array<Interval, count> d;
  Interval& operator[](std::size_t order) { return d[order]; }
  const Interval& operator[](std::size_t order) const { return d[order]; }
};

template <std::size_t count>
using JetVec = std::array<Jet<count>, 3>;

/// The sum over i in [from, to] of the binomials (k, i) times a_i b_(k - i): Leibniz' rule.
template <class A, class B>
Interval leibniz(const A& a, const B& b, std::size_t k, std::size_t from, std::size_t to) {
  Interval sum;
  double binomial = 1;
  for (std::size_t i = 0; i <= to; ++i) {
    if (i >= from) {
      sum = sum + Interval(binomial) * a[i] * b[k - i];
    }
    binomial = binomial * double(k - i) / double(i + 1);
  }
  return sum;
}

template <std::size_t count>
Jet<count> operator+(Jet<count> a, const Jet<count>& b) {
  for (std::size_t k = 0; k < count; ++k) {
    a[k] = a[k] + b[k];
  }
  return a;
}

template <std::size_t count>
Jet<count> operator-(Jet<count> a, const Jet<count>& b) {
  for (std::size_t k = 0; k < count; ++k) {
    a[k] = a[k] - b[k];
  }
  return a;
}

template <std::size_t count>
Jet<count> operator*(const Jet<count>& a, const Jet<count>& b) {
  Jet<count> c;
  for (std::size_t k = 0; k < count; ++k) {
    c[k] = leibniz(a, b, k, 0, k);
  }
  return c;
}

/// A function that stands still.
template <std::size_t count>
Jet<count> constant(const Interval& value) {
  return {{value}};
}

template <std::size_t count>
Jet<count> operator*(const Interval& s, Jet<count> a) {
  for (Interval& derivative : a.d) {
    derivative = s * derivative;
  }
  return a;
}

template <std::size_t count>
Jet<count> square(const Jet<count>& a) {
  Jet<count> result = a * a;
  result[0] = numbers::square(a[0]);
  return result;
}

/// Requires b > 0.
template <std::size_t count>
Jet<count> operator/(const Jet<count>& a, const Jet<count>& b) {
  Jet<count> c;
  for (std::size_t k = 0; k < count; ++k) {
    c[k] = (k == 0 ? a[0] : a[k] - leibniz(c, b, k, 0, k - 1)) / b[0];
  }
  return c;
}

/// Requires a > 0.
template <std::size_t count>
Jet<count> sqrt(const Jet<count>& a) {
  Jet<count> c;
  c[0] = sqrt(a[0]);
  for (std::size_t k = 1; k < count; ++k) {
    c[k] = (a[k] - leibniz(c, c, k, 1, k - 1)) / (Interval(2) * c[0]);
  }
  return c;
}

template <std::size_t count>
Jet<count> dot(const JetVec<count>& a, const JetVec<count>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <std::size_t count>
Jet<count> squared_norm(const JetVec<count>& v) {
  return square(v[0]) + square(v[1]) + square(v[2]);
}

template <std::size_t count>
JetVec<count> operator*(const Jet<count>& s, const JetVec<count>& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

template <std::size_t count>
JetVec<count> operator*(const Interval& s, const JetVec<count>& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

template <std::size_t count>
JetVec<count> operator*(const Jet<count>& s, const IntervalVec& v) {
  return {v[0] * s, v[1] * s, v[2] * s};
}

template <std::size_t count>
Jet<count> dot(const JetVec<count>& a, const IntervalVec& b) {
  return b[0] * a[0] + b[1] * a[1] + b[2] * a[2];
}

template <std::size_t count>
JetVec<count> operator-(const JetVec<count>& a, const JetVec<count>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <std::size_t count>
JetVec<count> operator/(const JetVec<count>& v, const Jet<count>& s) {
  return {v[0] / s, v[1] / s, v[2] / s};
}

template <std::size_t count>
Jet<count - 1> derivative(const Jet<count>& a) {
  Jet<count - 1> result;
  for (std::size_t k = 1; k < count; ++k) {
    result[k - 1] = a[k];
  }
  return result;
}

template <std::size_t count>
JetVec<count - 1> derivative(const JetVec<count>& v) {
  return {derivative(v[0]), derivative(v[1]), derivative(v[2])};
}

template <std::size_t count>
JetVec<count> operator+(const JetVec<count>& a, const JetVec<count>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <std::size_t count>
JetVec<count> cross(const JetVec<count>& a, const JetVec<count>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Without the derivatives beyond.
template <std::size_t count, std::size_t more>
Jet<count> shortened(const Jet<more>& a) {
  Jet<count> result;
  std::copy_n(a.d.begin(), count, result.d.begin());
  return result;
}

template <std::size_t count, std::size_t more>
JetVec<count> shortened(const JetVec<more>& v) {
  return {shortened<count>(v[0]), shortened<count>(v[1]), shortened<count>(v[2])};
}

/// The values, first derivatives and so on of all three coordinates.
template <std::size_t count>
IntervalVec part(const JetVec<count>& v, std::size_t order) {
  return {v[0][order], v[1][order], v[2][order]};
}

}  // namespace dupin::verification
