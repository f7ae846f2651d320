#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace dupin::drawing {

template <class Point>
[[nodiscard]] double distance_from_segment(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp(along.dot(point - from) / squared, 0.0, 1.0) : 0.0;
  return (from + s * along - point).norm();
}

template <class Point>
[[nodiscard]] double length(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    sum += (line[i] - line[i - 1]).norm();
  }
  return sum;
}

/// The polyline without points that the rest is within `tolerance` of, one after the other.
template <class Point>
[[nodiscard]] std::vector<Point> simplified(const std::vector<Point>& line, double tolerance) {
  std::vector<Point> result{line.front()};
  std::size_t from = 0;
  for (std::size_t to = 2; to < line.size(); ++to) {
    const bool is_near =
        std::all_of(line.begin() + std::ptrdiff_t(from) + 1, line.begin() + std::ptrdiff_t(to),
                    [&](const Point& point) {
                      return distance_from_segment(point, line[from], line[to]) <= tolerance;
                    });
    if (!is_near) {
      from = to - 1;
      result.push_back(line[from]);
    }
  }
  result.push_back(line.back());
  return result;
}

}  // namespace dupin::drawing
