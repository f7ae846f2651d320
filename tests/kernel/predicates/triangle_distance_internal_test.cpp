#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "predicates/triangle_distance.h"
#include "support/clipped_triangle.h"

namespace dupin::predicates {
namespace {

using test::cross;
using test::dot;
using test::minus;
using test::Rational3;
using Corners = std::array<Vec3, 3>;

ExactTriangle exact(const Corners& t) {
  ExactTriangle result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = {t[i].x(), t[i].y(), t[i].z()};
  }
  return result;
}

mpq_class measured(const Corners& a, const Corners& b) {
  const Fraction f = squared_distance(exact(a), exact(b));
  return exact::rational(f.numerator) / exact::rational(f.denominator);
}

Rational3 scaled(const mpq_class& s, const Rational3& v) { return {s * v[0], s * v[1], s * v[2]}; }
mpq_class norm(const Rational3& v) { return dot(v, v); }

/// The square of the distance of the origin from a segment or triangle if its foot is inside.
std::optional<mpq_class> foot(const Rational3& p, const Rational3& q) {
  const Rational3 u = minus(q, p);
  if (norm(u) == 0) {
    return std::nullopt;
  }
  const mpq_class s = -dot(p, u) / norm(u);
  return s < 0 || s > 1 ? std::nullopt : std::optional(norm(minus(p, scaled(-s, u))));
}
std::optional<mpq_class> foot(const Rational3& p, const Rational3& q, const Rational3& r) {
  const Rational3 u = minus(q, p), v = minus(r, p);
  const mpq_class uu = norm(u), vv = norm(v), uv = dot(u, v), up = -dot(u, p), vp = -dot(v, p);
  const mpq_class d = uu * vv - uv * uv;
  if (d == 0) {
    return std::nullopt;
  }
  const mpq_class s = (up * vv - vp * uv) / d, t = (vp * uu - up * uv) / d;
  return s < 0 || t < 0 || s + t > 1
             ? std::nullopt
             : std::optional(norm(minus(minus(p, scaled(-s, u)), scaled(-t, v))));
}
bool holds_origin(const std::array<Rational3, 4>& t) {
  std::array<int, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational3 &p = t[(i + 1) % 4], &q = t[(i + 2) % 4], &r = t[(i + 3) % 4];
    const Rational3 normal = cross(minus(q, p), minus(r, p));
    const int own = sgn(mpq_class(dot(normal, minus(t[i], p))));
    sides[i] = own * sgn(mpq_class(-dot(normal, p)));
    if (own == 0) {
      return false;
    }
  }
  return *std::min_element(sides.begin(), sides.end()) >= 0;
}

/// The same by another road: the point of least norm in the convex hull of all differences of
/// corners lies in a simplex of them (Caratheodory).
mpq_class by_differences(const Corners& a, const Corners& b) {
  std::vector<Rational3> p;
  for (const Vec3& from : a) {
    for (const Vec3& to : b) {
      p.push_back(minus(test::rational(to), test::rational(from)));
    }
  }
  mpq_class least = norm(p[0]);
  const auto lower = [&least](const std::optional<mpq_class>& candidate) {
    least = candidate && *candidate < least ? *candidate : least;
  };
  for (std::size_t i = 0; i < 9; ++i) {
    lower(norm(p[i]));
    for (std::size_t j = i + 1; j < 9; ++j) {
      lower(foot(p[i], p[j]));
      for (std::size_t k = j + 1; k < 9; ++k) {
        lower(foot(p[i], p[j], p[k]));
        for (std::size_t l = k + 1; l < 9; ++l) {
          lower(holds_origin({p[i], p[j], p[k], p[l]}) ? std::optional<mpq_class>(0)
                                                       : std::nullopt);
        }
      }
    }
  }
  return least;
}

TEST(TriangleDistance, of_each_pair_of_features) {
  const Corners base = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  EXPECT_EQ(measured(base, {Vec3(1, 1, 3), Vec3(9, 1, 9), Vec3(1, 9, 9)}), 9);      // corner, face
  EXPECT_EQ(measured(base, {Vec3(-1, -2, 2), Vec3(-9, 0, 9), Vec3(0, -9, 9)}), 9);  // corners
  EXPECT_EQ(measured(base, {Vec3(1, -3, 4), Vec3(1, -9, 9), Vec3(2, -9, 9)}), 25);  // edge, corner
  EXPECT_EQ(measured(base, {Vec3(1, -1, 2), Vec3(1, 1, 0), Vec3(1, 9, 90)}), 0);
  EXPECT_EQ(measured(base, {Vec3(1, -1, 0), Vec3(1, -1, 9), Vec3(2, -1, 9)}), 1);
  EXPECT_EQ(measured(base, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 9)}), 0);  // pierced
}

TEST(TriangleDistance, of_an_ulp_is_exact) {
  const double tiny = 0x1p-1074;
  EXPECT_EQ(measured({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)},
                     {Vec3(1, 1, tiny), Vec3(2, 1, 1), Vec3(1, 2, 1)}),
            mpq_class(1, mpz_class(1) << 2148));
}

TEST(TriangleDistance, agrees_with_the_hull_of_differences) {
  std::mt19937 random(20263);
  int met = 0, apart = 0;
  while (met + apart < 150) {
    const int range = met + apart < 75 ? 3 : 12;
    const auto triangle = [&] {
      Corners t;
      for (Vec3& p : t) {
        for (double& x : p) {
          x = 0.25 * static_cast<int>(random() % static_cast<unsigned>(range));
        }
      }
      return t;
    };
    const Corners a = triangle(), b = triangle();
    const auto flat = [](const Corners& t) {
      return Vec3(t[1] - t[0]).cross(t[2] - t[0]).isZero(0);
    };
    if (flat(a) || flat(b)) {
      continue;
    }
    const mpq_class expected = by_differences(a, b);
    EXPECT_EQ(measured(a, b), expected);
    EXPECT_EQ(measured(b, a), expected);
    ++(expected == 0 ? met : apart);
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(apart, 20);
}

}  // namespace
}  // namespace dupin::predicates
