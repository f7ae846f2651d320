#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numbers/interval.h"

namespace dupin::numbers {

inline IntervalVec hull(const IntervalVec& a, const IntervalVec& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}

/// Encloses the control points (numbers or vectors) of a Bezier polynomial on the part t of [0, 1]:
/// its blossoms.
template <class T>
[[nodiscard]] std::vector<T> bezier_part(const std::vector<T>& points, const Interval& t) {
  std::vector<T> part;
  for (std::size_t times_upper = 0; times_upper < points.size(); ++times_upper) {
    std::vector<T> row = points;
    for (std::size_t r = 1; r < points.size(); ++r) {
      const Interval at = r <= times_upper ? t.upper : t.lower;
      for (std::size_t i = 0; i + r < points.size(); ++i) {
        row[i] = (Interval(1) - at) * row[i] + at * row[i + 1];
      }
    }
    part.push_back(row.front());
  }
  return part;
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
