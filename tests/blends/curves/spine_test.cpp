#include "dupin/blends/spine.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/regularity.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

// The same curve as the cubic Hermite spine.
BezierSpine as_bezier(const HermiteSpine& h) {
  return {{h.from, h.from + h.start_velocity / 3, h.to - h.end_velocity / 3, h.to}};
}

TEST(BezierSpine, of_degree_three_is_the_hermite_spine) {
  const HermiteSpine hermite = test::skew_spine(10, 20);
  const BezierSpine bezier = as_bezier(hermite);
  BezierSpine rational = bezier;
  rational.weights = {2, 2, 2, 2};
  for (const BezierSpine& spine : {bezier, rational}) {
    for (int i = 0; i <= 10; ++i) {
      const SpinePoint a = evaluate(Spine(hermite), i / 10.), b = evaluate(Spine(spine), i / 10.);
      EXPECT_LT((a.position - b.position).norm(), 1e-14);
      EXPECT_LT((a.first - b.first).norm(), 1e-13);
      EXPECT_LT((a.second - b.second).norm(), 1e-12);
      EXPECT_LT((a.third - b.third).norm(), 1e-12);
    }
    const RingedSurface surface{{}, {}, spine, CubicRadius{1, 2}};
    EXPECT_NEAR(regularity(surface, {1e-10}).lower, 0.0848584660472, 1e-10);
  }
}

TEST(BezierSpine, meets_its_ends_exactly) {
  BezierSpine spine{{Vec3(.1, .2, .3), Vec3(1, 1, 1), Vec3(.7, .9, .3)}, {.3, .7, .11}};
  EXPECT_EQ(evaluate(Spine(spine), 0).position, spine.points.front());
  EXPECT_EQ(evaluate(Spine(spine), 1).position, spine.points.back());
}

TEST(StraightEndedSpine, has_the_tabulated_margin_on_figure_6) {
  const HermiteSpine ends = test::skew_spine(10, 20);
  const BezierRadius quintic{{1, 1, 1, 2, 2, 2}}, septic{{1, 1, 1, 1, 2, 2, 2, 2}};
  EXPECT_NEAR(regularity({{}, {}, quintic_spine(ends), quintic}).lower, -.3076, 6e-5);
  EXPECT_NEAR(regularity({{}, {}, septic_spine(ends), septic}).lower, -.6627, 6e-5);
}

TEST(StraightEndedSpine, has_no_curvature_at_its_ends) {
  const HermiteSpine ends = test::skew_spine(10, 20);
  for (const Spine& spine : {Spine(quintic_spine(ends)), Spine(septic_spine(ends))}) {
    for (const double t : {0., 1.}) {
      const SpinePoint y = evaluate(spine, t);
      EXPECT_LT((y.first - (t == 0 ? ends.start_velocity : ends.end_velocity)).norm(), 1e-13);
      EXPECT_LT(y.first.cross(y.second).norm(), 1e-11);
    }
    EXPECT_LT(evaluate(Spine(septic_spine(ends)), 0).third.norm(), 1e-11);
  }
}

}  // namespace
}  // namespace dupin
