#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "curves/exact_spine.h"
#include "support/paper_surfaces.h"

namespace dupin::curves {
namespace {

Vec3 value(const std::vector<numbers::ExactVec3>& v, double t) {
  numbers::ExactVec3 sum;
  for (std::size_t i = v.size(); i > 0; --i) {
    sum = mpq_class(t) * sum + v[i - 1];
  }
  return {sum[0].get_d(), sum[1].get_d(), sum[2].get_d()};
}

double value(const std::vector<mpq_class>& p, double t) {
  mpq_class sum;
  for (std::size_t i = p.size(); i > 0; --i) {
    sum = sum * mpq_class(t) + p[i - 1];
  }
  return sum.get_d();
}

const BezierSpine kQuintic{
    {Vec3(0, 0, 0), Vec3(1, .1, 0), Vec3(2, 1, .3), Vec3(3, 2, 1), Vec3(3, 3, 3), Vec3(.7, 4, 3)}};

TEST(ExactSpine, velocity_is_that_of_the_spine) {
  const LineSpine line{Vec3(1, 2, 3), Vec3(.1, .2, .7)};
  const HermiteSpine hermite = test::skew_spine(10, 20);
  BezierSpine rational = kQuintic;
  rational.weights = {1, 2, .5, 1.5, .25, 3};
  for (const double t : {0., .3, .75, 1.}) {
    EXPECT_LT((value(velocity(line), t) - evaluate(line, t).first).norm(), 1e-15);
    EXPECT_LT((value(velocity(hermite), t) - evaluate(hermite, t).first).norm(), 1e-13);
    for (const BezierSpine& spine : {kQuintic, rational}) {
      const RationalVelocity v = velocity(spine);
      const double w = value(v.weight, t);
      EXPECT_LT((value(v.numerator, t) / (w * w) - evaluate(spine, t).first).norm(), 1e-12);
    }
  }
}

TEST(ExactSpine, velocity_has_no_leading_zeros) {
  // A straight line, raised to degree 3, with equal weights.
  const BezierSpine raised{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)},
                           {2, 2, 2, 2}};
  const RationalVelocity v = velocity(raised);
  EXPECT_EQ(v.numerator.size(), 1u);
  EXPECT_EQ(v.weight.size(), 1u);
  EXPECT_EQ(velocity(kQuintic).weight, std::vector<mpq_class>{1});
}

TEST(ExactSpine, plane_normal_is_that_of_the_plane) {
  const Vec3 normal = Vec3(1, 2, -2) / 3, u = Vec3(2, 1, 2), v = Vec3(2, -2, -1);
  const HermiteSpine plane{Vec3(0, 0, 0), 3 * u + v, 4 * u, 2 * v};
  const auto found = plane_normal(plane);
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::abs(found->dot(normal)), 1, 1e-15);
  const auto arc = plane_normal(ArcSpine{Vec3(0, 0, 0), 2 * normal, u, 1});
  ASSERT_TRUE(arc);
  EXPECT_LT((*arc - normal).norm(), 1e-15);
}

TEST(ExactSpine, plane_normal_tells_one_ulp_out_of_the_plane) {
  HermiteSpine spine{Vec3(0, 0, 0), Vec3(3, 1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_TRUE(plane_normal(spine));
  spine.end_velocity.z() = std::ldexp(1, -1074);
  EXPECT_FALSE(plane_normal(spine));
  EXPECT_FALSE(plane_normal(test::skew_spine(10, 20)));
}

TEST(ExactSpine, plane_normal_of_a_straight_spine_is_any_across_it) {
  const Vec3 along(.3, -.7, .2);
  for (const Spine& spine :
       {Spine(LineSpine{Vec3(1, 1, 1), Vec3(1, 1, 1) + along}),
        Spine(HermiteSpine{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0, 0), Vec3(7, 0, 0)})}) {
    const auto normal = plane_normal(spine);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->norm(), 1, 1e-15);
    EXPECT_NEAR(normal->dot(evaluate(spine, 0).first), 0, 1e-15);
  }
  EXPECT_TRUE(plane_normal(LineSpine{Vec3(1, 1, 1), Vec3(1, 1, 1)}));  // of a point, some
}

TEST(ExactSpine, plane_normal_has_a_direction_where_doubles_would_overflow) {
  const HermiteSpine large{Vec3(0, 0, 0), Vec3(1e200, 1e200, 0), Vec3(1e200, 0, 0),
                           Vec3(0, 1e200, 0)};
  const auto normal = plane_normal(large);
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->cwiseAbs(), Vec3::UnitZ());
}

}  // namespace
}  // namespace dupin::curves
