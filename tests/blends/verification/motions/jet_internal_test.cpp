#include <cmath>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "verification/motions/jet.h"

namespace dupin::verification {
namespace {

using test::holds;

Jet<4> parameter(const Interval& t) { return {{t, 1, 0, 0}}; }

constexpr double kFrom = .25, kTo = .3125;

// Rounding of the C library's functions.
constexpr double kSlack = 1e-13;

// Whether the jet over the stretch holds the function and its derivatives at places of it.
template <class Function>
void expect_holds(const Jet<4>& jet, const Function& derivatives) {
  for (const double t : {kFrom, .26, .3, kTo}) {
    const std::array<double, 4> d = derivatives(t);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_TRUE(holds(jet[k], d[k], kSlack)) << t << " " << k;
    }
  }
}

// At one place the jet is the derivatives but for rounding.
template <class Function>
void expect_is(const Jet<4>& jet, const Function& derivatives, double t) {
  const std::array<double, 4> d = derivatives(t);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_TRUE(holds(jet[k], d[k], kSlack)) << k;
    EXPECT_LT(jet[k].upper - jet[k].lower, 1e-10) << k;
  }
}

TEST(Jet, products_follow_leibniz) {
  // (1 + t) t^2 = t^2 + t^3
  const auto d = [](double t) {
    return std::array{t * t + t * t * t, 2 * t + 3 * t * t, 2 + 6 * t, 6.};
  };
  const auto f = [](const Interval& at) {
    const Jet<4> t = parameter(at), one{{1, 0, 0, 0}};
    return (one + t) * (t * t);
  };
  expect_holds(f({kFrom, kTo}), d);
  expect_is(f(.75), d, .75);
}

TEST(Jet, quotients_have_the_derivatives_of_the_quotient) {
  const auto d = [](double t) {
    const double x = 1 / (1 + t);
    return std::array{x, -x * x, 2 * x * x * x, -6 * x * x * x * x};
  };
  const auto f = [](const Interval& at) {
    const Jet<4> one{{1, 0, 0, 0}};
    return one / (one + parameter(at));
  };
  expect_holds(f({kFrom, kTo}), d);
  expect_is(f(.75), d, .75);
}

TEST(Jet, roots_have_the_derivatives_of_the_root) {
  const auto d = [](double t) {
    const double s = 1 + t, root = std::sqrt(s);
    return std::array{root, .5 / root, -.25 / (s * root), .375 / (s * s * root)};
  };
  const auto f = [](const Interval& at) {
    const Jet<4> one{{1, 0, 0, 0}};
    return sqrt(one + parameter(at));
  };
  expect_holds(f({kFrom, kTo}), d);
  expect_is(f(.75), d, .75);
}

TEST(Jet, vectors_are_their_coordinates) {
  // (t, t^2, 1) . (1 - t, 2, t) = 2 t + t^2 ... and its square's norm t^2 + t^4 + 1.
  const auto f = [](const Interval& at) -> std::pair<Jet<4>, Jet<4>> {
    const Jet<4> t = parameter(at), one{{1, 0, 0, 0}}, two{{2, 0, 0, 0}};
    const JetVec<4> a{t, t * t, one}, b{one - t, two, t};
    return {dot(a, b), squared_norm(a)};
  };
  const auto product = [](double t) { return std::array{t * t + 2 * t, 2 * t + 2, 2., 0.}; };
  const auto norm = [](double t) {
    return std::array{1 + t * t + t * t * t * t, 2 * t + 4 * t * t * t, 2 + 12 * t * t, 24 * t};
  };
  expect_holds(f({kFrom, kTo}).first, product);
  expect_holds(f({kFrom, kTo}).second, norm);
  expect_is(f(.5).first, product, .5);
  expect_is(f(.5).second, norm, .5);
  EXPECT_GE(squared_norm(JetVec<2>{{{{{Interval(-1, 1), 1}}}, {{{0, 0}}}, {{{0, 0}}}}})[0].lower,
            -1e-300);
}

TEST(Jet, derivative_shifts_the_orders) {
  const Jet<4> t = parameter(.5), cube = t * t * t;
  const Jet<3> slope = derivative(cube);
  EXPECT_TRUE(holds(slope[0], .75));
  EXPECT_TRUE(holds(slope[1], 3));
  EXPECT_TRUE(holds(slope[2], 6));
  const JetVec<4> v{t, cube, t - cube};
  EXPECT_TRUE(holds(part(derivative(v), 0), Vec3(1, .75, .25)));
  EXPECT_TRUE(holds(part((cube * v) / cube, 0), Vec3(.5, .125, .375)));
}

TEST(Jet, narrowed_is_rounded_outward) {
  const Interval pi = narrowed(Mpfi::pi());
  EXPECT_LT(pi.lower, pi.upper);
  EXPECT_EQ(numbers::next_above(pi.lower), pi.upper);
  EXPECT_EQ(pi.lower, 3.141592653589793);
}

}  // namespace
}  // namespace dupin::verification
