#include <array>
#include <cmath>
#include <random>

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "predicates/sign_filter.h"

namespace dupin::predicates {
namespace {

using UpwardRounding = CGAL::Protect_FPU_rounding<true>;
using Rational3 = std::array<mpq_class, 3>;

Rational3 difference(const Vec3& a, const Vec3& b) {
  return {mpq_class(a.x()) - mpq_class(b.x()), mpq_class(a.y()) - mpq_class(b.y()),
          mpq_class(a.z()) - mpq_class(b.z())};
}

Rational3 exact_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Rational3 u = difference(b, a), v = difference(c, a);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Rational3 n = exact_normal(a, b, c), d = difference(p, a);
  return sgn(mpq_class(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]));
}

struct Sample {
  Vec3 a, b, c, p;
};

// Points nearly in one plane, on it to within a few units in the last place, or anywhere; of sizes
// from near underflow to near overflow.
Sample random_sample(std::mt19937_64& random, int round) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double scale =
      std::ldexp(1.0, std::array{0, 300, -250, -340, 40}[static_cast<std::size_t>(round % 5)]);
  const auto point = [&] {
    return Vec3(Vec3(uniform(random), uniform(random), uniform(random)) * scale);
  };
  Sample s{point(), point(), point(), point()};
  if (round % 3 != 0) {
    s.p = s.a + uniform(random) * (s.b - s.a) + uniform(random) * (s.c - s.a);
  }
  return s;
}

TEST(SignFilter, of_planes_is_right_where_it_is_certain) {
  std::mt19937_64 random(31);
  int certain = 0, uncertain = 0;
  for (int round = 0; round < 6000; ++round) {
    const auto [a, b, c, p] = random_sample(random, round);
    const int side = PlaneFilter(a, b, c).side(p);
    if (side != 0) {
      ASSERT_EQ(side, exact_side(a, b, c, p)) << round;
    }
    ++(side != 0 ? certain : uncertain);
  }
  EXPECT_GT(certain, 1500);
  EXPECT_GT(uncertain, 1500);
}

TEST(SignFilter, of_lines_is_right_where_it_is_certain) {
  std::mt19937_64 random(32);
  int certain = 0;
  for (int round = 0; round < 6000; ++round) {
    auto [a, b, p, unused] = random_sample(random, round);
    if (round % 2 == 0) {
      p = a + (b - a) * 0.3;
    }
    const int axis = round % 3;
    const int side = side_of_line(a, b, p, axis);
    if (side != 0) {
      ASSERT_EQ(side, sgn(exact_normal(a, b, p)[static_cast<std::size_t>(axis)])) << round;
      ++certain;
    }
  }
  EXPECT_GT(certain, 2000);
}

TEST(SignFilter, of_edges_is_right_where_it_is_certain) {
  std::mt19937_64 random(35);
  int beyond = 0;
  for (int round = 0; round < 6000; ++round) {
    const auto [a, b, c, p] = random_sample(random, round);
    for (int axis = 0; axis < 3; ++axis) {
      const EdgeFilter edges({a, b, c}, axis);
      const int inner = sgn(exact_normal(a, b, c)[axis]);
      const std::array<int, 3> turns = {sgn(exact_normal(a, b, p)[axis]),
                                        sgn(exact_normal(b, c, p)[axis]),
                                        sgn(exact_normal(c, a, p)[axis])};
      for (int k = 0; k < 3; ++k) {
        if (edges.is_beyond(k, p)) {
          ASSERT_EQ(turns[k], -inner) << round;
          ASSERT_NE(inner, 0) << round;
          ++beyond;
        }
      }
    }
  }
  EXPECT_GT(beyond, 4000);
  const EdgeFilter edges({Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 5)}, 2);
  EXPECT_TRUE(edges.is_beyond(0, Vec3(-1, 0, 0)));
  EXPECT_FALSE(edges.is_beyond(0, Vec3(0, 2, 0))) << "on the line";
  EXPECT_FALSE(edges.is_beyond(0, Vec3(1, 9, 0)));
}

TEST(SignFilter, sees_nothing_in_degenerate_planes) {
  std::mt19937_64 random(33);
  std::uniform_int_distribution<int> integer(-9, 9);
  const auto vector = [&] { return Vec3(integer(random), integer(random), integer(random)); };
  for (int round = 0; round < 500; ++round) {
    const Vec3 a = vector(), along = vector(), p = vector();
    const PlaneFilter plane(a, a + 2 * along, a - 3 * along);
    EXPECT_FALSE(plane.certain());
    EXPECT_EQ(plane.side(p), 0);
  }
}

TEST(SignFilter, is_certain_of_what_is_far_from_zero) {
  const PlaneFilter plane(Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1));
  EXPECT_TRUE(plane.certain());
  EXPECT_EQ(plane.main_axis(), 2);
  EXPECT_EQ(plane.side(Vec3(5, 5, 2)), 1);
  EXPECT_EQ(plane.side(Vec3(5, 5, 0)), -1);
  EXPECT_EQ(plane.side(Vec3(5, 5, 1)), 0);
  const PlaneFilter overflowing(Vec3(0, 0, 0), Vec3(1e200, -1e200, 0), Vec3(0, 1e200, -1e200));
  EXPECT_FALSE(overflowing.certain());
  EXPECT_EQ(overflowing.side(Vec3(1, 2, 3)), 0);
}

// Points on and near the circle about one point, as far as doubles tell.
TEST(SignFilter, of_four_points_of_a_circle_is_exact_where_certain) {
  using Point = std::array<double, 2>;
  const auto exact = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto from = [&](const Point& p) {
      const mpq_class x = mpq_class(p[0]) - mpq_class(d[0]), y = mpq_class(p[1]) - mpq_class(d[1]);
      return Rational3{x, y, x * x + y * y};
    };
    const Rational3 u = from(a), v = from(b), w = from(c);
    return sgn(mpq_class(u[2] * (v[0] * w[1] - v[1] * w[0]) + v[2] * (w[0] * u[1] - w[1] * u[0]) +
                         w[2] * (u[0] * v[1] - u[1] * v[0])));
  };
  const UpwardRounding rounding;
  std::mt19937_64 random(34);
  std::uniform_real_distribution<double> angle(0, 6.28), off(-1, 1);
  int inside = 0, outside = 0;
  for (int round = 0; round < 5000; ++round) {
    const double size = round % 2 == 0 ? 1 : 0x1p-40;
    const auto place = [&](double turn, double radius) {
      return Point{1 + size * radius * std::cos(turn), size * radius * std::sin(turn)};
    };
    const double from = angle(random);
    const Point a = place(from, 1), b = place(from + 2, 1), c = place(from + 4, 1);
    const Point d = place(angle(random), 1 + off(random) * (round % 3 == 0 ? 0.1 : 0x1p-50));
    const bool certain = certainly_in_circle(a, b, c, d);
    const int sign = exact(a, b, c, d);
    ASSERT_TRUE(!certain || sign > 0) << round;
    inside += certain ? 1 : 0;
    outside += sign < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 200);
}

}  // namespace
}  // namespace dupin::predicates
