#pragma once

#include <array>

#include <CGAL/Mpzf.h>

namespace dupin::exact {

struct ExactVector : std::array<CGAL::Mpzf, 3> {};

[[nodiscard]] inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline CGAL::Mpzf dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline int sign(const CGAL::Mpzf& value) { return static_cast<int>(value.sign()); }

}  // namespace dupin::exact
