#include "dupin/kernel/ring.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

Ring random_ring(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-10, 10);
  const auto vector = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  return {vector(), vector().normalized(), std::abs(coordinate(random)) + 0.1, 0.2};
}

TEST(Ring, sample_of_the_flipped_ring_is_the_same_points_in_reverse) {
  std::mt19937_64 random(20061);
  for (int i = 0; i < 200; ++i) {
    const Ring ring = random_ring(random);
    const RingSampling sampling{17, 0.37, i % 2 == 0 ? 0 : std::ldexp(1.0, -16)};
    auto there = sample(ring, sampling);
    const auto back = sample(flipped(ring), sampling);
    std::reverse(there.begin() + 1, there.end());
    EXPECT_EQ(there, back);
  }
}

TEST(Ring, sample_of_an_axis_aligned_flipped_ring_is_the_same_points_in_reverse) {
  for (int axis = 0; axis < 3; ++axis) {
    const Ring ring{Vec3(1, 2, 3), -Vec3::Unit(axis), 2};
    auto there = sample(ring, {12});
    std::reverse(there.begin() + 1, there.end());
    EXPECT_EQ(there, sample(flipped(ring), {12}));
  }
}

TEST(Ring, sample_runs_counter_clockwise_on_the_circle) {
  std::mt19937_64 random(20062);
  for (int i = 0; i < 50; ++i) {
    const Ring ring = random_ring(random);
    const auto points = sample(ring, {24});
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec3 a = points[k] - ring.center;
      const Vec3 b = points[(k + 1) % points.size()] - ring.center;
      EXPECT_NEAR(a.norm(), ring.radius, 1e-13 * (ring.radius + ring.center.norm()));
      EXPECT_GT(a.cross(b).dot(ring.normal), 0);
    }
  }
}

TEST(Ring, sample_of_an_ellipse_lies_on_it_and_is_shared_with_the_flipped_ring) {
  const Ring ring{{1, 2, 3}, {0.6, 0, 0.8}, 2, 0, Ellipse{Vec3(-0.8, 0, 0.6), 0.5}};
  const Vec3 side = ring.normal.cross(ring.ellipse->axis);
  for (const double phase : {0.0, 0.3}) {
    auto points = sample(ring, {9, phase});
    for (const Vec3& point : points) {
      const double x = (point - ring.center).dot(ring.ellipse->axis) / 2;
      const double y = (point - ring.center).dot(side) / 0.5;
      EXPECT_NEAR(x * x + y * y, 1, 1e-14);
    }
    const auto back = sample(flipped(ring), {9, phase});
    std::reverse(points.begin() + 1, points.end());
    EXPECT_EQ(points, back);
  }
}

TEST(Ring, flipping_twice_gives_the_ring) {
  std::mt19937_64 random(20063);
  const Ring ring = random_ring(random);
  EXPECT_EQ(flipped(flipped(ring)), ring);
}

TEST(Ring, circles_are_no_further_from_each_other_than_told) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal = vector().normalized();
    const double tilt = i % 4 == 0 ? 0 : 0.3;
    const Ring a{vector(), normal, 2 + number(random)};
    const Ring b{a.center + 0.2 * vector(), (normal + tilt * vector()).normalized(),
                 2 + number(random)};
    const double bound = circle_distance(a, b);
    EXPECT_EQ(circle_distance(flipped(a), b), bound) << "whichever way they run";
    double furthest = 0;
    for (const Vec3& point : sample(a, {48})) {
      const Vec3 from = point - b.center;
      const double height = from.dot(b.normal), out = (from - height * b.normal).norm();
      furthest = std::max(furthest, std::hypot(height, out - b.radius));
    }
    EXPECT_LE(furthest, bound * (1 + 1e-12));
    EXPECT_GE(furthest, bound / 4) << "and not much nearer";
  }
}

TEST(Ring, a_bad_ring_is_refused) {
  const double nan = std::nan("");
  EXPECT_THROW((void)sample({Vec3(0, 0, nan), Vec3::UnitX(), 1}, {8}), Error);
  EXPECT_THROW((void)sample({Vec3::Zero(), Vec3(1, 1, 0), 1}, {8}), Error);
  EXPECT_THROW((void)sample({Vec3::Zero(), Vec3::UnitX(), 0}, {8}), Error);
  EXPECT_THROW((void)sample({Vec3::Zero(), Vec3::UnitX(), 1}, {2}), Error);
}

TEST(Ring, is_refused_where_its_points_are_too_many_or_too_far_away) {
  EXPECT_THROW((void)sample({}, {.segments = 0xffffffff}), Error);
  EXPECT_THROW((void)sample({Vec3(1.7e308, 0, 0), Vec3::UnitZ(), 1e308}, {8}), Error);
}

// From 2^52 steps on, all doubles are whole numbers of them.
TEST(Ring, points_stay_where_the_lattice_is_finer_than_doubles) {
  const Vec3 point(1, -1.7e308, 0.25);
  for (const double grid : {5e-324, 0x1p-1060, 0x1p-54}) {
    EXPECT_EQ(snapped(point, grid), point);
  }
  EXPECT_EQ(snapped(point, 0x1p900), Vec3(0, -1.7e308, 0));
  EXPECT_EQ(snapped(Vec3(1.3, -1.3, -0.1), 0.5), Vec3(1.5, -1.5, 0));
}

TEST(Ring, is_sampled_from_an_angle_and_on_a_lattice_that_are_numbers) {
  for (const double number : {std::nan(""), double(INFINITY)}) {
    EXPECT_THROW((void)sample({}, {.segments = 8, .phase = number}), Error);
    EXPECT_THROW((void)sample({}, {.segments = 8, .grid = number}), Error);
  }
}

}  // namespace
}  // namespace dupin
