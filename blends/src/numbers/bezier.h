#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "numbers/interval.h"

namespace dupin::numbers {

/// See bezier_jet(). Works in the control points, which are some.
template <class T>
[[nodiscard]] std::array<T, 4> bezier_jet_within(std::span<T> row, double t) {
  const T zero = row.front() - row.front();
  std::array<T, 4> jet{zero, zero, zero, zero};
  const auto degree = static_cast<double>(row.size() - 1);
  for (std::size_t n = row.size(); n > 0; --n) {
    switch (n) {
      case 4:
        jet[3] = degree * (degree - 1) * (degree - 2) * (row[3] - row[0] - 3 * (row[2] - row[1]));
        break;
      case 3:
        jet[2] = degree * (degree - 1) * (row[2] - 2 * row[1] + row[0]);
        break;
      case 2:
        jet[1] = degree * (row[1] - row[0]);
        break;
      case 1:
        jet[0] = row[0];
        break;
      default:
        break;
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
      row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
  }
  return jet;
}

/// A Bezier polynomial's value and first three derivatives at t, from the last four rows of one de
/// Casteljau scheme.
template <class T>
[[nodiscard]] std::array<T, 4> bezier_jet(const std::vector<T>& points, double t) {
  constexpr std::size_t kFew = 12;  // most have no more, and are asked for very often
  if (points.size() > kFew) {
    std::vector<T> row = points;
    return bezier_jet_within(std::span<T>(row), t);
  }
  std::array<T, kFew> row;
  std::copy(points.begin(), points.end(), row.begin());
  return bezier_jet_within(std::span<T>(row).first(points.size()), t);
}

inline IntervalVec hull(const IntervalVec& a, const IntervalVec& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}

/// One step of de Casteljau's scheme at t on the first `count` points: one less is left.
template <class T>
void casteljau_step(std::vector<T>& points, std::size_t count, const Interval& t) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    points[i] = (Interval(1) - t) * points[i] + t * points[i + 1];
  }
}

/// Encloses the control points (numbers or vectors) of a Bezier polynomial on the part t of [0, 1],
/// cut off at its lower end, then at its upper one. O(n^2).
template <class T>
[[nodiscard]] std::vector<T> bezier_part(std::vector<T> points, const Interval& t) {
  const std::size_t count = points.size();
  if (t.lower != 0) {  // what is left of each row is its last point
    for (std::size_t left = count; left > 1; --left) {
      casteljau_step(points, left, t.lower);
    }
  }
  if (t.upper != 1) {
    const Interval end = (Interval(t.upper) - t.lower) / (Interval(1) - t.lower);
    std::vector<T> row = points;
    for (std::size_t i = 0; i < count; ++i) {
      points[i] = row.front();
      casteljau_step(row, count - i, end);
    }
  }
  return points;
}

/// Encloses a Bezier polynomial (of numbers or vectors) on t: the hull of its control points there.
template <class T>
[[nodiscard]] T bezier_range(const std::vector<T>& points, const Interval& t) {
  const std::vector<T> part = bezier_part(points, t);
  T range = part.front();
  for (const T& point : part) {
    range = hull(range, point);
  }
  return range;
}

/// Encloses a Bezier polynomial and its first three derivatives on t.
template <class T>
[[nodiscard]] std::array<T, 4> bezier_jet(std::vector<T> points, const Interval& t) {
  std::array<T, 4> result;
  for (T& derivative : result) {
    derivative = bezier_range(points, t);
    const Interval degree = static_cast<double>(points.size() - 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      points[i] = degree * (points[i + 1] - points[i]);
    }
    if (points.size() > 1) {
      points.pop_back();
    } else {
      points.front() = T{};
    }
  }
  return result;
}

}  // namespace dupin::numbers
