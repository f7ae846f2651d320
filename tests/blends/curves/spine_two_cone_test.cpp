#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/spine.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

const std::array<Vec3, 4> kVertices{Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 6, 5)};

BezierSpine example() { return two_cone_spine(kVertices, {1, 1, 1}, {1, 2, 1}); }

double torsion(const SpinePoint& y) {
  const Vec3 bend = y.first.cross(y.second);
  return bend.dot(y.third) / bend.squaredNorm();
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

TEST(TwoConeSpine, runs_along_the_axes_at_its_ends) {
  const BezierSpine spine = two_cone_spine(kVertices, {1, 2, 1}, {1, .5, 3});
  EXPECT_EQ(spine.points.size(), 4u);
  EXPECT_EQ(evaluate(spine, 0).position, kVertices[0]);
  EXPECT_EQ(evaluate(spine, 1).position, kVertices[3]);
  const auto expect_along = [](const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.normalized().dot(b.normalized()), 1, 1e-15);
  };
  expect_along(evaluate(spine, 0).first, kVertices[1] - kVertices[0]);
  expect_along(evaluate(spine, 1).first, kVertices[3] - kVertices[2]);
}

// Only the conics matter, which are the same for (m1, m2, m3) and (c m1, c m2, c m3).
TEST(TwoConeSpine, is_the_same_curve_for_multiples_of_the_weights) {
  const BezierSpine one = two_cone_spine(kVertices, {1, 2, 1}, {1, .5, 3});
  const BezierSpine other = two_cone_spine(kVertices, {4, 8, 4}, {.25, .125, .75});
  for (double t = 0; t <= 1; t += .125) {
    EXPECT_LT((evaluate(one, t).position - evaluate(other, t).position).norm(), 1e-14);
  }
}

TEST(TwoConeSpine, refuses_weights_that_are_no_positive_numbers) {
  for (const double bad : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)two_cone_spine(kVertices, {1, bad, 1}, {1, 1, 1}), Error);
    EXPECT_THROW((void)two_cone_spine(kVertices, {1, 1, 1}, {1, 1, bad}), Error);
  }
}

}  // namespace
}  // namespace dupin
