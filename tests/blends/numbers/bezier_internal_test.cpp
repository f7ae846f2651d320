#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/vec.h"
#include "numbers/bezier.h"
#include "numbers/polynomial.h"

namespace dupin::numbers {
namespace {

std::vector<double> random_points(std::mt19937_64& random, std::size_t size) {
  std::uniform_real_distribution<double> number(-3, 3);
  std::vector<double> points;
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back(number(random));
  }
  return points;
}

// The value and three derivatives at t, exactly, by powers.
std::array<mpq_class, 4> exact_jet(const std::vector<double>& points, const mpq_class& t) {
  Polynomial p = power_basis(std::vector<mpq_class>(points.begin(), points.end()));
  std::array<mpq_class, 4> jet;
  for (mpq_class& value : jet) {
    for (std::size_t i = p.size(); i > 0; --i) {
      value = value * t + p[i - 1];
    }
    for (std::size_t i = 1; i < p.size(); ++i) {
      p[i - 1] = mpq_class(static_cast<unsigned long>(i)) * p[i];
    }
    p.back() = 0;
  }
  return jet;
}

bool holds(const Interval& a, const mpq_class& x) {
  return mpq_class(a.lower) <= x && x <= mpq_class(a.upper);
}

TEST(Bezier, jet_in_doubles_is_that_of_the_powers) {
  std::mt19937_64 random(3);
  for (std::size_t size = 1; size <= 8; ++size) {
    const std::vector<double> points = random_points(random, size);
    for (const double t : {0., .25, .7, 1.}) {
      const auto found = bezier_jet(points, t);
      const auto expected = exact_jet(points, t);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(found[k], expected[k].get_d(), 1e-11) << size << " " << t << " " << k;
      }
    }
  }
}

TEST(Bezier, jet_of_vectors_is_that_of_their_coordinates) {
  const std::vector<Vec3> points{Vec3(0, 1, 2), Vec3(1, -1, 0), Vec3(3, 2, 2), Vec3(4, 0, 7),
                                 Vec3(1, 1, 1)};
  const auto whole = bezier_jet(points, .3);
  for (int k = 0; k < 3; ++k) {
    std::vector<double> coordinate;
    for (const Vec3& p : points) {
      coordinate.push_back(p[k]);
    }
    const auto jet = bezier_jet(coordinate, .3);
    for (std::size_t order = 0; order < 4; ++order) {
      EXPECT_DOUBLE_EQ(whole[order][k], jet[order]);
    }
  }
}

TEST(Bezier, jet_in_intervals_holds_that_of_every_parameter) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::size_t size = 1; size <= 7; ++size) {
    const std::vector<double> points = random_points(random, size);
    for (int i = 0; i < 20; ++i) {
      const double a = unit(random), b = unit(random);
      const Interval t(std::min(a, b), std::max(a, b));
      const auto found = bezier_jet(std::vector<Interval>(points.begin(), points.end()), t);
      for (const double share : {0., .3, 1.}) {
        const mpq_class at = mpq_class(t.lower) + mpq_class(share) * (mpq_class(t.upper) - t.lower);
        const auto expected = exact_jet(points, at);
        for (std::size_t k = 0; k < 4; ++k) {
          EXPECT_TRUE(holds(found[k], expected[k])) << size << " " << k;
        }
      }
    }
  }
}

TEST(Bezier, range_shrinks_to_the_value_with_the_interval) {
  const std::vector<Interval> points{1, -2, 3, 0.5};
  double before = 1e9;
  for (int i = 0; i < 20; ++i) {
    const double width = std::ldexp(1, -i - 2);
    const Interval range = bezier_range(points, {.5 - width, .5 + width});
    EXPECT_LT(range.upper - range.lower, before);
    before = range.upper - range.lower;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(Bezier, part_has_the_control_points_of_the_part) {
  // t^2 on [a, b] has the blossoms a a, a b, b b.
  const double a = .25, b = .75;
  const std::vector<Interval> part = bezier_part(std::vector<Interval>{0, 0, 1}, {a, b});
  ASSERT_EQ(part.size(), 3u);
  const std::vector<double> expected{a * a, a * b, b * b};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(holds(part[i], expected[i]));
    EXPECT_LT(part[i].upper - part[i].lower, 1e-14);
  }
}

TEST(Bezier, part_holds_the_blossoms_at_its_ends) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::size_t size = 1; size <= 10; ++size) {
    const std::vector<double> points = random_points(random, size);
    const double a = unit(random);
    for (const Interval& t :
         {Interval(a, std::nextafter(a, 2.)), Interval(a / 2, a), Interval(0, a), Interval(a, 1),
          Interval(0, 1), Interval(0, 0), Interval(1, 1), Interval(a, a), Interval(a, 1.25)}) {
      const auto part = bezier_part(std::vector<Interval>(points.begin(), points.end()), t);
      ASSERT_EQ(part.size(), size);
      for (std::size_t uppers = 0; uppers < size; ++uppers) {
        std::vector<mpq_class> row(points.begin(), points.end());
        for (std::size_t r = 1; r < size; ++r) {
          const mpq_class at = r <= uppers ? t.upper : t.lower;
          for (std::size_t i = 0; i + r < size; ++i) {
            row[i] = (1 - at) * row[i] + at * row[i + 1];
          }
        }
        EXPECT_TRUE(holds(part[uppers], row.front())) << size << ' ' << t.lower << ' ' << t.upper;
        EXPECT_LT(part[uppers].upper - part[uppers].lower, 1e-9) << size << ' ' << t.upper;
      }
    }
  }
}

}  // namespace
}  // namespace dupin::numbers
