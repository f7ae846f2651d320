#pragma once

#include <array>

#include <gmpxx.h>

#include "dupin/blends/pe_arc.h"

namespace dupin::detail {

using ExactVec = std::array<mpq_class, 3>;

/// A vector of R^{3,1} with rational coordinates.
struct ExactPeVector {
  ExactVec m;
  mpq_class r;
};

inline ExactPeVector exact(const PeVector& a) { return {{a.m.x(), a.m.y(), a.m.z()}, a.r}; }

inline mpq_class dot(const ExactVec& a, const ExactVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline ExactPeVector operator-(const ExactPeVector& a, const ExactPeVector& b) {
  return {{a.m[0] - b.m[0], a.m[1] - b.m[1], a.m[2] - b.m[2]}, a.r - b.r};
}

inline mpq_class product(const ExactPeVector& a, const ExactPeVector& b) {
  return dot(a.m, b.m) - a.r * b.r;
}

/// lhs > -sqrt(square), square >= 0.
inline bool exceeds_negative_root(const mpq_class& lhs, const mpq_class& square) {
  return lhs > 0 || lhs * lhs < square;
}

}  // namespace dupin::detail
