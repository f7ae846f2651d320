#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "curves/exact_radius.h"
#include "dupin/kernel/error.h"

namespace dupin::curves {
namespace {

mpq_class value(const numbers::Polynomial& p, const mpq_class& t) {
  mpq_class sum;
  for (std::size_t i = p.size(); i > 0; --i) {
    sum = sum * t + p[i - 1];
  }
  return sum;
}

TEST(ExactRadius, polynomials_are_the_laws) {
  const std::vector<RadiusLaw> laws{ConstantRadius{.7}, LinearRadius{.3, 1.1}, CubicRadius{1, 2.6},
                                    BezierRadius{{1, .2, .9, .4, 2}}, BezierRadius{{.1}}};
  for (const RadiusLaw& law : laws) {
    const auto p = polynomial(law);
    ASSERT_TRUE(p);
    for (const double t : {0., .25, .6, 1.}) {
      EXPECT_NEAR(value(*p, t).get_d(), evaluate(law, t).value, 1e-14);
    }
    EXPECT_EQ(value(*p, 0), mpq_class(evaluate(law, 0).value));
    EXPECT_EQ(value(*p, 1), mpq_class(evaluate(law, 1).value));
  }
  EXPECT_FALSE(polynomial(CyclideRadius{1, 2}));
}

TEST(ExactRadius, refuses_what_is_no_number) {
  EXPECT_THROW((void)polynomial(ConstantRadius{std::nan("")}), Error);
  EXPECT_THROW((void)polynomial(LinearRadius{1, std::numeric_limits<double>::infinity()}), Error);
}

// R solves R^2 + (end - start) cos(pi t) R = start end; at t = 1/2 and 1/3 the cosine is rational.
TEST(ExactRadius, of_the_cyclide_law_encloses_the_root) {
  for (const auto& [start, end] : {std::pair(1., 2.), {2., 1.}, {.001, 1000.}, {3., 3.}}) {
    const CyclideRadius law{start, end};
    const auto holds_root = [&](const numbers::Interval& r, const mpq_class& cosine) {
      const mpq_class a = start, b = end;
      const auto side = [&](const mpq_class& x) {
        return sgn(mpq_class(x * x + (b - a) * cosine * x - a * b));
      };
      return side(r.lower) <= 0 && side(r.upper) >= 0;
    };
    EXPECT_TRUE(holds_root(enclosed_radius(law, 0), 1));
    EXPECT_TRUE(holds_root(enclosed_radius(law, .5), 0));
    EXPECT_TRUE(holds_root(enclosed_radius(law, 1), -1));
    EXPECT_EQ(enclosed_radius(law, 0).lower, start);
    EXPECT_EQ(enclosed_radius(law, 1).upper, end);
    for (double t = 0; t <= 1; t += .0625) {
      const numbers::Interval r = enclosed_radius(law, t);
      EXPECT_NEAR(r.lower, evaluate(law, t).value, 1e-12 * r.upper);
      EXPECT_LE(r.upper - r.lower, 1e-15 * r.upper);
      EXPECT_LE(r.lower, r.upper);
    }
  }
}

TEST(ExactRadius, second_derivative_is_within_its_bound) {
  for (const auto& [start, end] : {std::pair(1., 2.), {2., 1.}, {.1, 1.}, {3., 3.}}) {
    const CyclideRadius law{start, end};
    double largest = 0;
    for (int i = 0; i <= 1000; ++i) {
      largest = std::max(largest, std::abs(evaluate(law, i / 1000.).second));
    }
    const double bound = second_derivative_bound(law);
    EXPECT_GE(bound, largest);
    EXPECT_TRUE(std::isfinite(bound));
    EXPECT_LE(bound, 20 * largest + 40 * std::max(start, end));
  }
}

}  // namespace
}  // namespace dupin::curves
