#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "blends/junction/junction_meshes_internal.h"
#include "dupin/kernel/error.h"
#include "junction/hub_mesh.h"
#include "support/icosahedron.h"

namespace dupin::junction {
namespace {

using test::JunctionMesh;

Ring towards_origin(const Vec3& from, double radius, double distance) {
  const Vec3 unit = from.normalized();
  return {distance * unit, -unit, radius};
}

// Closed, embedded, as near as is said, of triangles that are not slivers.
void expect_sound(const Junction& junction, double tolerance, double degrees) {
  const JunctionMesh mesh = test::mesh_of(junction, tolerance, std::ldexp(1, -18));
  const int ends = int(junction.arms.size());
  EXPECT_EQ(test::euler_number(mesh.open), 2 - ends);
  EXPECT_EQ(test::euler_number(mesh.closed), 2);
  EXPECT_NO_THROW((void)Solid::from(mesh.closed));
  EXPECT_LE(mesh.hub.error_bound, tolerance);
  EXPECT_GE(smallest_angle(mesh.hub.mesh) * 180 / std::numbers::pi, degrees);
  for (const Triangle& t : mesh.hub.mesh.triangles) {
    for (const auto& [u, v] : {std::pair(0.33, 0.33), std::pair(0.5, 0.5), std::pair(0.1, 0.6)}) {
      const Vec3 point = (1 - u - v) * mesh.hub.mesh.points[t[0]] + u * mesh.hub.mesh.points[t[1]] +
                         v * mesh.hub.mesh.points[t[2]];
      EXPECT_LE(std::abs((point - junction.hub.center).norm() - junction.hub.radius),
                mesh.hub.error_bound);
    }
  }
}

TEST(HubMesh, of_six_pipes_is_sound) {
  std::vector<Ring> ends;
  for (int i = 0; i < 3; ++i) {
    ends.push_back(towards_origin(Vec3::Unit(i), 1, 4));
    ends.push_back(towards_origin(-Vec3::Unit(i), 1, 4));
  }
  expect_sound(junction_of(ends), 0.02, 20);
  expect_sound(junction_of(ends, {.smoothness = 1}), 0.02, 20);
}

TEST(HubMesh, of_two_opposite_pipes_with_large_caps_is_a_band) {
  const std::vector<Ring> ends{towards_origin({1, 0, 0}, 1, 5), towards_origin({-1, 0, 0}, 1, 5)};
  expect_sound(junction_of(ends), 0.02, 20);
  const double degree = std::numbers::pi / 180;
  expect_sound(junction_of(ends, {Vec3(0, 0, 0), 1.1, {85 * degree, 85 * degree}}), 0.02, 15);
}

// One thick pipe and a bundle of thin ones: points are dense only where circles are small.
TEST(HubMesh, follows_the_sizes_of_its_circles) {
  std::vector<Ring> ends{towards_origin({0, 0, -1}, 2, 12)};
  for (int i = 0; i < 5; ++i) {
    ends.push_back(towards_origin({std::cos(1.256 * i), std::sin(1.256 * i), 1.5}, 0.1, 12));
  }
  expect_sound(junction_of(ends), 0.02, 15);
}

TEST(HubMesh, of_caps_that_cover_nearly_all_of_the_sphere) {
  std::vector<Ring> ends;
  for (const Vec3& direction : test::icosahedron_corners()) {
    ends.push_back(towards_origin(direction, 0.5, 8));
  }
  const double widest = std::atan(2) / 2;  // half the angle between neighbours
  expect_sound(junction_of(ends, {Vec3(0, 0, 0), 1.2, std::vector<double>(12, 0.99 * widest)}),
               0.01, 2);
}

TEST(HubMesh, gets_finer_with_the_tolerance) {
  const std::vector<Ring> ends{towards_origin({1, 0, 0}, 1, 5), towards_origin({-1, 1, 0}, 1, 5),
                               towards_origin({-1, -1, 1}, 1, 5)};
  const Junction junction = junction_of(ends);
  const auto coarse = test::mesh_of(junction, 0.05, 0), fine = test::mesh_of(junction, 0.0125, 0);
  EXPECT_LT(fine.hub.error_bound, coarse.hub.error_bound / 2);
  const double growth =
      double(fine.hub.mesh.triangles.size()) / double(coarse.hub.mesh.triangles.size());
  EXPECT_GT(growth, 2);
  EXPECT_LT(growth, 8);
}

TEST(HubMesh, refuses_polygons_that_touch_and_too_many_triangles) {
  const std::vector<Ring> ends{towards_origin({1, 0, 0}, 1, 5), towards_origin({0, 1, 0}, 1, 5),
                               towards_origin({-1, -1, 0}, 1, 5)};
  const Junction junction = junction_of(ends);
  std::vector<std::vector<Vec3>> circles;
  for (const JunctionArm& arm : junction.arms) {
    circles.push_back(sample(cap_circle(arm), {64}));
  }
  const auto code = [&](const HubSampling& sampling) {
    try {
      (void)hub_mesh(junction, circles, sampling);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::internal;
  };
  EXPECT_EQ(code({0.05, 0, 10}), Errc::limit_exceeded);
  circles[1] = circles[0];
  EXPECT_EQ(code({0.05, 0}), Errc::infeasible_blend);
}

}  // namespace
}  // namespace dupin::junction
