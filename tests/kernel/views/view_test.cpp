#include "dupin/kernel/view.h"

#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

TEST(View, of_the_usual_directions) {
  const View front = view_along(Vec3::UnitY()), plan = view_along(-Vec3::UnitZ());
  EXPECT_EQ(front.right, Vec3::UnitX());
  EXPECT_EQ(front.up, Vec3::UnitZ());
  EXPECT_EQ(front.towards, -Vec3::UnitY());
  EXPECT_EQ(plan.right, Vec3::UnitX());
  EXPECT_EQ(plan.up, Vec3::UnitY());
  EXPECT_EQ(plan({1, 2, 3}), Vec3(1, 2, 3));
  EXPECT_EQ(view_along(-Vec3::UnitZ(), Vec3::UnitX()).up, Vec3::UnitX());
}

TEST(View, is_a_right_handed_frame) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(10.0, 200 * normal(random) / 3);
    const Vec3 direction = size * Vec3(normal(random), normal(random), normal(random));
    const View view = view_along(direction);
    Eigen::Matrix3d frame;
    frame << view.right, view.up, view.towards;
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(frame.determinant(), 1, 1e-14);
    EXPECT_LT(view.towards.dot(direction / direction.cwiseAbs().maxCoeff()), 0);
    EXPECT_GE(view.up[2], 0);
  }
}

TEST(View, refuses_what_is_no_direction) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Vec3& bad : {Vec3(0, 0, 0), Vec3(nan, 1, 0), Vec3(1, infinity, 0)}) {
    EXPECT_THROW((void)view_along(bad), Error);
    EXPECT_THROW((void)view_along(Vec3::UnitX(), bad), Error);
  }
  EXPECT_THROW((void)view_along(Vec3(1, 2, 3), Vec3(-2, -4, -6)), Error);
}

}  // namespace
}  // namespace dupin
