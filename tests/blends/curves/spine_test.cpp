#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/tessellate.h"
#include "dupin/blends/two_cone_spine.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

const std::array<Vec3, 4> kVertices{Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 6, 5)};

BezierSpine example() { return two_cone_spine(kVertices, {1, 1, 1}, {1, 2, 1}); }

double torsion(const SpinePoint& y) {
  const Vec3 bend = y.first.cross(y.second);
  return bend.dot(y.third) / bend.squaredNorm();
}

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

struct TwoConeRow {
  double t;
  Vec3 position;
  double speed, curvature, torsion;
};

class TwoConeSpine : public testing::TestWithParam<TwoConeRow> {};

TEST_P(TwoConeSpine, agrees_with_the_table) {
  const TwoConeRow row = GetParam();
  const SpinePoint y = evaluate(Spine(example()), row.t);
  EXPECT_LT((y.position - row.position).norm(), 2e-14);
  EXPECT_NEAR(y.first.norm() / row.speed, 1, 1e-14);
  EXPECT_NEAR(curvature(y), row.curvature, 1e-14);
  EXPECT_NEAR(torsion(y), row.torsion, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
    Example, TwoConeSpine,
    testing::Values(TwoConeRow{0, Vec3(4, 0, 0), 16, .03125, .0146484375},
                    TwoConeRow{.25, Vec3(3.81456953642384, 2.36707663197729, 0.00473036896877956),
                               5.75666254801388, 0.273366497436485, 0.077731296169428},
                    TwoConeRow{.5, Vec3(3.29896907216495, 3.36082474226804, 0.0515463917525773),
                               4.09920708986099, 0.628776783231916, 0.387946673996701},
                    TwoConeRow{.75, Vec3(2.19525065963061, 3.97361477572559, 0.356200527704485),
                               7.55477050592551, 0.270216291007954, 0.942114123305641},
                    TwoConeRow{1, Vec3(0, 6, 5), 86.1626369141521, 0.0689655172413793,
                               0.00808189655172414}));

TEST(TwoConeSpine, has_the_tabulated_weights_length_and_energy) {
  EXPECT_EQ(example().weights, (std::vector<double>{16, 64. / 3, 16. / 3, 1}));
  EXPECT_NEAR(length(example()), 10.6483825841939, 1e-13);
  EXPECT_NEAR(bending_energy(example()), 0.800857981481, 1e-12);
}

TEST(TwoConeSpine, of_equal_weights_has_the_tabulated_ends) {
  const Spine spine = two_cone_spine(kVertices, {1, 1, 1}, {1, 1, 1});
  EXPECT_NEAR(curvature(evaluate(spine, 0)), .125, 1e-15);
  EXPECT_NEAR(torsion(evaluate(spine, 0)), .05859375, 1e-15);
  EXPECT_NEAR(curvature(evaluate(spine, 1)), .0689655172414, 1e-13);
  EXPECT_NEAR(torsion(evaluate(spine, 1)), .0323275862069, 1e-13);
}

TEST(TwoConeSpine, lies_on_both_cones) {
  const std::array<double, 3> m{1, 1.5, .7}, w{.8, 2, 1.3};
  const Spine spine = two_cone_spine(kVertices, m, w);
  Eigen::Matrix4d tetrahedron;
  for (int i = 0; i < 4; ++i) {
    tetrahedron.col(i) << kVertices[i], 1;
  }
  for (int i = 1; i < 10; ++i) {
    Eigen::Vector4d point;
    point << evaluate(spine, i / 10.).position, 1;
    const Eigen::Vector4d l = tetrahedron.inverse() * point;
    EXPECT_NEAR(l[2] * l[2] * m[0] * m[2], 4 * m[1] * m[1] * l[1] * l[3], 1e-14);
    EXPECT_NEAR(l[1] * l[1] * w[0] * w[2], 4 * w[1] * w[1] * l[0] * l[2], 1e-14);
  }
}

TEST(TwoConeSpine, has_a_certified_largest_curvature) {
  const RingedSurface tube{{}, {}, example(), ConstantRadius{1}};
  const Regularity r = regularity(tube, {1e-10});
  double sampled = 0;
  for (int i = 0; i <= 200; ++i) {
    sampled = std::max(sampled, curvature(evaluate(tube.spine, i / 200.)));
  }
  EXPECT_NEAR(sampled, .64155003, 6e-9);
  EXPECT_GE(1 - r.lower, sampled);
  EXPECT_NEAR(1 - r.lower, sampled, 1e-4);
  EXPECT_EQ(prove_margin(tube, .358).verdict, Verdict::proved);
  EXPECT_EQ(prove_margin(tube, .3585).verdict, Verdict::refuted);
}

TEST(TwoConeSpine, refuses_weights_that_are_not_positive) {
  EXPECT_THROW((void)two_cone_spine(kVertices, {1, 0, 1}, {1, 1, 1}), Error);
  EXPECT_THROW((void)two_cone_spine({kVertices[0], Vec3(NAN, 0, 0)}, {1, 1, 1}, {1, 1, 1}), Error);
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

TEST(BezierSpine, second_derivative_bounds_contain_samples) {
  const RingedSurface surface{{}, {}, example(), BezierRadius{{1, 1.2, .7, .8}}};
  for (const double from : {0., .3, .8}) {
    const double to = from + .05;
    const SecondDerivativeBounds bounds = second_derivative_bounds(surface, from, to);
    const FrameField frames(surface.spine, Vec3::UnitX());
    const double h = 1e-4;
    for (double t = from + h; t < to - h; t += .01) {
      for (double u = 0; u < 6; u += .7) {
        const auto x = [&](double s) { return evaluate(surface, frames, s, u).position; };
        const double along = ((x(t + h) - 2 * x(t) + x(t - h)) / (h * h)).norm();
        EXPECT_LE(along, bounds.along + 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace dupin
