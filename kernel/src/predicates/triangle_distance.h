#pragma once

#include <array>

#include "exact/exact_numbers.h"

namespace dupin::predicates {

/// An exact quotient; the denominator is positive.
struct Fraction {
  CGAL::Mpzf numerator, denominator = 1;
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};

using ExactTriangle = std::array<exact::ExactVector, 3>;

/// The square of the distance between two triangles with area, exactly: 0 if they meet, else the
/// least over the pairs of features (corner, edge, face) that see each other at right angles.
[[nodiscard]] Fraction squared_distance(const ExactTriangle& a, const ExactTriangle& b);

}  // namespace dupin::predicates
