#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace dupin::numbers {

/// A Bezier polynomial's value and first three derivatives at t, from the last four rows of one de
/// Casteljau scheme. Takes its control points by value to work in.
template <class T>
[[nodiscard]] std::array<T, 4> bezier_jet(std::vector<T> row, double t) {
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

}  // namespace dupin::numbers
