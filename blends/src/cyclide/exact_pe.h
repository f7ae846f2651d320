#pragma once

#include <gmpxx.h>

#include "dupin/blends/pe_arc.h"
#include "numbers/exact_vec3.h"

// Dupin cyclides as arcs of spheres [SD94]. An oriented sphere of centre m and radius r is the
// point (m; r) of the pseudo-Euclidean space R^{3,1} with <a, b> = a.m . b.m - a.r b.r, and <a - b,
// a - b> is the squared length of the segments tangent to both. A piece of a cyclide, torus, cone
// or cylinder is what the spheres of a conic arc envelop, the arc being given by its start, a unit
// tangent T0 = (A; tau) there and its end (dupin/blends/pe_arc.h): with d = end - start, L^2 =
// <d, d> and w = <d, T0> / L, its Bezier weights are (1, w, 1). The four inequalities V1 to V4 that
// make it a regular tube are polynomial in these numbers but for roots that can be squared away;
// here they are rational. A second family of spheres touches the piece along its other lines of
// curvature (complementary_sphere.h): points, circles and patches come from it.
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
