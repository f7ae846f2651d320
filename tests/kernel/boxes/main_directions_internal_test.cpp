#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "boxes/main_directions.h"
#include "kernel/torus.h"
#include "support/shapes.h"

namespace dupin::boxes {
namespace {

Vec3 random_unit(std::mt19937& random) {
  std::normal_distribution<double> number;
  return Vec3(number(random), number(random), number(random)).normalized();
}

/// Two bundles of long thin tubes, one across the other, in a turned frame.
TriMesh crossing_tubes(const Eigen::Matrix3d& axes) {
  std::vector<TriMesh> tubes;
  for (int i = 0; i < 6; ++i) {
    TriMesh tube = test::tube(0.1, i < 4 ? -20 : -5, i < 4 ? 20 : 5, 16);
    for (Vec3& p : tube.points) {
      p = axes.transpose() * Vec3(i < 4 ? p : Vec3(p.z(), p.x(), p.y())) + Vec3(i, 2 * i, 0);
    }
    tubes.push_back(tube);
  }
  return test::joined(tubes);
}

TEST(MainDirections, are_those_of_most_long_edges) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d frame = orthonormal(random_unit(random), random_unit(random));
    const TriMesh mesh = crossing_tubes(frame);
    const auto axes = main_directions(mesh.points, mesh.triangles);
    if (frame.cwiseAbs().maxCoeff() > 0.95) {
      continue;  // nearly the coordinate axes, which may do as well
    }
    ASSERT_TRUE(axes);
    EXPECT_GT(std::abs(axes->row(0).dot(frame.row(2))), 0.999) << "along the long tubes";
    EXPECT_GT(std::abs(axes->row(1).dot(frame.row(0))), 0.99) << "along the others";
    EXPECT_LT((*axes * axes->transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
}

TEST(MainDirections, are_not_sought_along_coordinate_axes_or_without_long_edges) {
  const TriMesh along = crossing_tubes(Eigen::Matrix3d::Identity());
  EXPECT_FALSE(main_directions(along.points, along.triangles));
  const TriMesh round = test::torus(24, 48, 2, 1);
  EXPECT_FALSE(main_directions(round.points, round.triangles));
  EXPECT_FALSE(main_directions({}, {}));
}

// What is left of vectors along one direction is rounding, which may lie along it, too.
TEST(AxesAlongMost, are_found_where_all_vectors_are_parallel) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    const Vec3 direction = i == 0 ? Vec3(0.577, 0.577, 0.577) : random_unit(random);
    std::vector<Vec3> vectors;
    for (int k = 1; k < 40; ++k) {
      vectors.emplace_back((k % 2 == 0 ? 1 : -1) * (100 - k / 3.0) * direction);
    }
    const auto axes = axes_along_most(vectors);
    ASSERT_TRUE(axes);
    EXPECT_NEAR(std::abs(axes->row(0).dot(direction.normalized())), 1, 1e-12);
    EXPECT_LT((*axes * axes->transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
  EXPECT_FALSE(axes_along_most({}));
  EXPECT_FALSE(axes_along_most({Vec3::Zero()}));
  EXPECT_FALSE(axes_along_most({Vec3::Constant(1e300)}));
}

TEST(PrincipalAxes, are_those_in_which_points_spread_most_and_least) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d frame = orthonormal(random_unit(random), random_unit(random));
    std::vector<Vec3> points;
    for (int k = 0; k < 3000; ++k) {
      const Vec3 p = random_unit(random);
      points.emplace_back(frame.transpose() * Vec3(5 * p[0], 2 * p[1], p[2]) + Vec3(7, -3, 1));
    }
    const Eigen::Matrix3d axes = principal_axes(points);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT(std::abs(axes.row(k).dot(frame.row(k))), 0.95) << k;
    }
  }
  EXPECT_TRUE(principal_axes({}).allFinite());
}

TEST(Orthonormal, keeps_the_first_direction_and_the_plane_of_both) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 first = random_unit(random) * 3;
    const Vec3 second = first * 5 + random_unit(random) * std::ldexp(1.0, -(i % 20));
    const Eigen::Matrix3d axes = orthonormal(first, second);
    ASSERT_LT((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    ASSERT_NEAR(axes.row(0).dot(first), 3, 1e-14);
    ASSERT_NEAR(axes.row(2).dot(second), 0, 1e-13);
    ASSERT_GT(axes.row(1).dot(second), 0);
    ASSERT_GT(axes.determinant(), 0);
  }
}

}  // namespace
}  // namespace dupin::boxes
