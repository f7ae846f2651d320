#pragma once

#include <array>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/vec.h"

/// The intersection of two triangles by clipping one against half-spaces in rationals: slow, simple
/// and unlike the library's predicates.
namespace dupin::test {

using Rational3 = std::array<mpq_class, 3>;

inline Rational3 rational(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline Rational3 minus(const Rational3& a, const Rational3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational3 cross(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class dot(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The part of a convex polygon where normal . (x - origin) >= 0.
inline std::vector<Rational3> clipped(const std::vector<Rational3>& polygon,
                                      const Rational3& origin, const Rational3& normal) {
  std::vector<Rational3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Rational3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class side_p = dot(normal, minus(p, origin)), side_q = dot(normal, minus(q, origin));
    if (side_p >= 0) {
      kept.push_back(p);
    }
    if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
      const mpq_class t = side_p / (side_p - side_q);
      const Rational3 d = minus(q, p);
      kept.push_back({p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]});
    }
  }
  return kept;
}

/// Corners (with repetitions) of the convex set that two triangles have in common; b is not
/// degenerate.
inline std::vector<Rational3> common_part(const std::array<Vec3, 3>& a,
                                          const std::array<Vec3, 3>& b) {
  const std::array<Rational3, 3> t = {rational(b[0]), rational(b[1]), rational(b[2])};
  std::vector<Rational3> part = {rational(a[0]), rational(a[1]), rational(a[2])};
  const Rational3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  part = clipped(part, t[0], normal);
  part = clipped(part, t[0], {-normal[0], -normal[1], -normal[2]});
  for (int i = 0; i < 3; ++i) {
    part = clipped(part, t[i], cross(normal, minus(t[(i + 1) % 3], t[i])));
  }
  return part;
}

/// Whether all points lie on one line.
inline bool on_one_line(const std::vector<Rational3>& points) {
  for (const Rational3& p : points) {
    for (const Rational3& q : points) {
      if (cross(minus(p, points[0]), minus(q, points[0])) != Rational3{0, 0, 0}) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace dupin::test
