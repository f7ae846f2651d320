#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

// Mathematics C6: skew pipes with equal tangent lengths.
CyclideChain skew() {
  const PeVector b0 = test::sphere(0, 0, 0, 1), b3 = test::sphere(4, 3, 5, .7);
  const PeVector t0{Vec3(0, 0, 1), 0};
  const PeArc first = PeArc::from(
      b0, t0, test::sphere(1.37075013397642, 0.661000178635233, 3.54874977670596, 0.85));
  return {{first, PeArc::from(first.end(), first.end_tangent(), b3)}};
}

TEST(ArcClearance, of_the_skew_pipes_is_the_oracle_s) {
  const Sphere ball{Vec3(3, 0, 3), .9};
  const CyclideChain chain = skew();
  const double expected[] = {0.09187477303113, 0.05651415104532};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(clearance(chain.pieces[i], ball), expected[i], 1e-13);
    EXPECT_TRUE(keeps_distance(chain.pieces[i], ball, expected[i] - 1e-12));
    EXPECT_FALSE(keeps_distance(chain.pieces[i], ball, expected[i] + 1e-12));
  }
  EXPECT_EQ(clearance(chain, ball), clearance(chain.pieces[1], ball));
}

// The least distance from the arc's balls to a point, by samples and refinement around the best.
double measured(const PeArc& arc, const Vec3& point) {
  double low = 0, high = 1, best = 0, least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 8; ++round) {
    const double step = (high - low) / 400;
    for (int i = 0; i <= 400; ++i) {
      const PeVector ball = sphere_at(arc, low + i * step);
      const double here = (ball.m - point).norm() - ball.r;
      if (here < least) {
        least = here;
        best = low + i * step;
      }
    }
    low = std::max(0.0, best - 2 * step);
    high = std::min(1.0, best + 2 * step);
  }
  return least;
}

TEST(ArcClearance, decisions_agree_with_brute_force) {
  test::RandomArcs arcs;
  int near = 0;
  for (int i = 0; i < 205; ++i) {
    const PeArc arc = arcs.next();
    if (arc.w() < -0.9) {
      continue;  // samples by parameter are too sparse there
    }
    const Vec3 point = arcs.vector();
    const double expected = measured(arc, point);
    if (expected > 0) {
      EXPECT_NEAR(clearance(arc, {point, 0}), expected, 1e-9);
      EXPECT_FALSE(contains(arc, point));
      const Sphere ball{point, expected / 2};
      EXPECT_TRUE(keeps_distance(arc, ball, expected / 2 * (1 - 1e-9)));
      EXPECT_FALSE(keeps_distance(arc, ball, expected / 2 * (1 + 1e-9)));
      ++near;
    } else {
      EXPECT_TRUE(contains(arc, point));
      EXPECT_NEAR(clearance(arc, {point, 0}), expected, 1e-9);
      EXPECT_NEAR(clearance(arc, {point, 1}), expected - 1, 1e-9);
    }
  }
  EXPECT_GT(near, 100);
}

// Deeper than the thinnest ball is thick: those count that are thicker.
TEST(ArcClearance, points_deep_inside_are_as_deep_as_in_the_deepest_ball) {
  const PeArc cone = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), .25),
                                 test::sphere(0, 0, 4, 2));
  EXPECT_NEAR(clearance(cone, {Vec3(0, 0, 4), 0}), -2, 1e-12);
  EXPECT_NEAR(clearance(cone, {Vec3(0, 0, 0), 0}), -1, 1e-12);
  const double r2 = 1 + .25 * 2;
  EXPECT_NEAR(clearance(cone, {Vec3(0, 0, 2), 0}), -r2, 1e-12);
  EXPECT_NEAR(clearance(cone, {Vec3(0, 0, 2), 0.5}), -r2 - 0.5, 1e-12);
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    if (arc.w() < -0.9) {
      continue;
    }
    for (const double t : {0.0, 0.2, 0.7, 1.0}) {
      const Vec3 point = sphere_at(arc, t).m + 0.2 * sphere_at(arc, t).r * Vec3::UnitY();
      EXPECT_NEAR(clearance(arc, {point, 0}), measured(arc, point), 1e-9);
    }
  }
}

TEST(ArcClearance, touching_is_neither_inside_nor_clear) {
  const PeArc pipe =
      PeArc::from(test::sphere(0, 0, 0, 1), {Vec3::UnitX(), 0}, test::sphere(4, 0, 0, 1));
  const Vec3 on_it(2, 1, 0);
  EXPECT_FALSE(contains(pipe, on_it));
  EXPECT_FALSE(keeps_distance(pipe, {on_it, 0}, 0));
  EXPECT_TRUE(contains(pipe, {2, std::nextafter(1.0, 0), 0}));
  EXPECT_TRUE(keeps_distance(pipe, {{2, std::nextafter(1.0, 2), 0}, 0}, 0));
  EXPECT_FALSE(keeps_distance(pipe, {{2, 3, 0}, 1}, 1));
  EXPECT_THROW((void)keeps_distance(pipe, {on_it, -1}, 0), Error);
  EXPECT_THROW((void)keeps_distance(pipe, {on_it, 1}, -1), Error);
}

}  // namespace
}  // namespace dupin
