#include <cmath>
#include <numbers>
#include <numeric>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "numbers/quadrature.h"

namespace dupin::numbers {
namespace {

TEST(Quadrature, nodes_and_weights_are_the_librarys) {
  using Library = boost::math::quadrature::gauss<long double, 30>;
  const Quadrature rule = gauss_panels(1);
  ASSERT_EQ(rule.nodes.size(), 30u);
  for (std::size_t i = 0; i < 15; ++i) {  // the library lists those right of the middle
    const long double x = Library::abscissa()[i], w = Library::weights()[i];
    EXPECT_EQ(rule.nodes[15 + i], static_cast<double>((1 + x) / 2));
    EXPECT_EQ(rule.nodes[14 - i], static_cast<double>((1 - x) / 2));
    EXPECT_NEAR(rule.weights[15 + i], static_cast<double>(w / 2), 1e-17);
    EXPECT_NEAR(rule.weights[14 - i], static_cast<double>(w / 2), 1e-17);
  }
}

TEST(Quadrature, is_exact_for_polynomials_of_degree_59) {
  for (const int panels : {1, 3}) {
    const Quadrature rule = gauss_panels(panels);
    EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.), 1, 1e-15);
    for (const int degree : {1, 2, 29, 58, 59}) {
      EXPECT_NEAR(integral([=](double t) { return std::pow(t, degree); }, rule), 1. / (degree + 1),
                  1e-16);
    }
  }
  // Of degree 60 it is not, but by less than one would see on [0, 1].
  const Quadrature rule = gauss_panels(1);
  const double error =
      integral([](double t) { return std::pow(100 * (2 * t - 1), 60) / 1e90; }, rule) - 1e30 / 61;
  EXPECT_GT(std::abs(error), 1e11);
}

TEST(Quadrature, nodes_ascend_over_all_panels) {
  const Quadrature rule = gauss_panels(4);
  EXPECT_EQ(rule.nodes.size(), 120u);
  for (std::size_t i = 0; i + 1 < rule.nodes.size(); ++i) {
    EXPECT_LT(rule.nodes[i], rule.nodes[i + 1]);
  }
  EXPECT_GT(rule.nodes.front(), 0);
  EXPECT_LT(rule.nodes.back(), 1);
}

TEST(Quadrature, of_smooth_functions_is_their_integral) {
  EXPECT_NEAR(integral([](double t) { return std::exp(t); }), std::numbers::e - 1, 1e-15);
  EXPECT_NEAR(integral([](double t) { return 4 / (1 + t * t); }), std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace dupin::numbers
