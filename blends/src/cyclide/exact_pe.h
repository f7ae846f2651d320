#pragma once

#include <gmpxx.h>

#include "dupin/blends/pe_arc.h"
#include "numbers/exact_vec3.h"

namespace dupin::cyclide {

/// A vector of R^{3,1} with rational coordinates.
struct ExactPeVector {
  numbers::ExactVec3 m;
  mpq_class r;
};

inline ExactPeVector exact(const PeVector& a) { return {{a.m.x(), a.m.y(), a.m.z()}, a.r}; }

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

}  // namespace dupin::cyclide
