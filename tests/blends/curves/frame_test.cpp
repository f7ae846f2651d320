#include "dupin/blends/frame.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

using test::skew_spine;

double angle_between(const Frame& a, const Frame& b) {
  return std::atan2(a.first.dot(b.second), a.first.dot(b.first));
}

TEST(FrameField, is_orthonormal_and_right_handed_everywhere) {
  const FrameField field(skew_spine(10, 20), Vec3::UnitY());
  for (int i = 0; i <= 1000; ++i) {
    const Frame f = field.at(i / 1000.0);
    EXPECT_NEAR(f.first.norm(), 1, 1e-15);
    EXPECT_NEAR(f.first.dot(f.tangent), 0, 1e-15);
    EXPECT_LT((f.tangent.cross(f.first) - f.second).norm(), 1e-15);
  }
}

struct StepRow {
  std::size_t knots;
  double error;
};

class FrameSteps : public testing::TestWithParam<StepRow> {};

TEST_P(FrameSteps, leave_the_tabulated_end_error_of_order_four) {
  const Frame truth = FrameField(skew_spine(10, 20), Vec3::UnitY(), {4096}).at(1);
  const Frame coarse = FrameField(skew_spine(10, 20), Vec3::UnitY(), {GetParam().knots}).at(1);
  EXPECT_NEAR(std::abs(angle_between(truth, coarse)) / GetParam().error, 1, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Figure6, FrameSteps,
                         testing::Values(StepRow{10, 1.49e-5}, StepRow{20, 9.90e-7},
                                         StepRow{40, 6.28e-8}, StepRow{80, 3.94e-9},
                                         StepRow{160, 2.46e-10}));

TEST(FrameField, differs_from_the_papers_frame_at_the_end_by_the_tabulated_turn) {
  const Frame end = FrameField(skew_spine(10, 20), Vec3::UnitY(), {2048}).at(1);
  const Vec3 paper = Vec3(-end.tangent.y(), end.tangent.x(), 0).normalized();
  EXPECT_NEAR(std::atan2(paper.dot(end.second), paper.dot(end.first)), 0.3414931663717, 1e-12);
}

TEST(FrameField, is_continuous_across_its_knots) {
  const FrameField field(skew_spine(10, 20), Vec3::UnitY(), {64});
  for (int i = 1; i <= 64; ++i) {
    const double t = i / 64.0;
    EXPECT_LT((field.at(t).first - field.at(std::nextafter(t, 0)).first).norm(), 1e-12);
  }
}

TEST(FrameField, keeps_the_plane_normal_of_coplanar_spines) {
  const HermiteSpine tilted{Vec3(0, 0, 0), Vec3(6, 6, 6), Vec3(10, 0, 5), Vec3(0, 10, 5)};
  const Vec3 normal = Vec3(-1, -1, 2).normalized();
  const FrameField field(tilted, normal);
  ASSERT_TRUE(field.plane_normal());
  EXPECT_NEAR(std::abs(field.plane_normal()->dot(normal)), 1, 1e-15);
  for (int i = 0; i <= 100; ++i) {
    EXPECT_LT((field.at(i / 100.0).first - normal).norm(), 1e-15);
  }
}

TEST(FrameField, of_a_coplanar_spine_minimises_rotation_from_any_start) {
  const HermiteSpine planar{Vec3(0, 0, 0), Vec3(6, 6, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  HermiteSpine spatial = planar;
  spatial.to.z() = 1e-13;  // out of the plane: forces the double reflection
  const Vec3 axis(0, 1, 2);
  const FrameField exact(planar, axis), stepped(spatial, axis);
  EXPECT_TRUE(exact.plane_normal());
  EXPECT_FALSE(stepped.plane_normal());
  for (const double t : {0.0, .2, .5, .9, 1.0}) {
    EXPECT_LT((exact.at(t).first - stepped.at(t).first).norm(), 1e-9) << t;
  }
}

TEST(FrameField, passes_where_the_papers_frame_degenerates) {
  // The tangent is the z axis at t = 4/5.
  const HermiteSpine spine{Vec3(0, 0, 0), Vec3(10, 4, 0), Vec3(240.0 / 7, 0, 0), Vec3(0, -12, 9)};
  EXPECT_NEAR(evaluate(Spine(spine), .8).first.head<2>().norm(), 0, 1e-13);
  const FrameField field(spine, Vec3::UnitY());
  EXPECT_LT((field.at(.8 - 1e-9).first - field.at(.8 + 1e-9).first).norm(), 1e-6);
}

TEST(FrameField, of_an_arc_turns_about_its_axis) {
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(3, 0, 0), std::numbers::pi / 2};
  const FrameField field(arc, Vec3::UnitX());
  EXPECT_LT((field.at(1).first - Vec3::UnitY()).norm(), 1e-15);
}

TEST(FrameField, of_a_line_is_constant) {
  const FrameField field(LineSpine{Vec3(1, 2, 3), Vec3(2, 4, 9)}, Vec3::UnitX());
  EXPECT_EQ(field.at(0).first, field.at(.7).first);
}

TEST(FrameField, refuses_an_axis_along_the_spine_and_a_spine_that_stops) {
  const LineSpine line{Vec3(0, 0, 0), Vec3(1, 2, 3)};
  EXPECT_THROW(FrameField(line, Vec3(2, 4, 6)), Error);
  EXPECT_THROW(FrameField(line, Vec3::Zero()), Error);
  EXPECT_THROW(FrameField(line, Vec3::UnitX(), {0}), Error);
  EXPECT_THROW(FrameField(LineSpine{Vec3(1, 1, 1), Vec3(1, 1, 1)}, Vec3::UnitX()), Error);
}

TEST(FrameField, turns_with_the_space) {
  std::mt19937_64 random(20064);
  std::normal_distribution<double> gauss;
  const HermiteSpine spine = skew_spine(10, 20);
  const FrameField field(spine, Vec3::UnitY());
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(gauss(random), gauss(random), gauss(random), gauss(random))
            .normalized()
            .toRotationMatrix();
    const HermiteSpine turned{turn * spine.from, turn * spine.to, turn * spine.start_velocity,
                              turn * spine.end_velocity};
    const FrameField turned_field(turned, turn * Vec3::UnitY());
    EXPECT_LT((turned_field.at(.77).first - turn * field.at(.77).first).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace dupin
