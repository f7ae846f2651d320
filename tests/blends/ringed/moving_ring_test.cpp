#include "dupin/blends/moving_ring.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

const TravelRing kRing{Vec3(1, 2, 3), Vec3(2, -1, 2) / 3, .8};

// A point of the ring that moves, at the time h; its normal turns as the ring's does.
Vec3 point(const MovingRing& ring, double angle, double h) {
  const Vec3 first = ring.normal.unitOrthogonal(), second = ring.normal.cross(first);
  const Vec3 e = std::cos(angle) * first + std::sin(angle) * second;
  const Vec3 turned = e - h * ring.normal_rate.dot(e) * ring.normal;
  return ring.center + h * ring.center_rate + (ring.radius + h * ring.radius_rate) * turned;
}

// The normal of the surface that the ring sweeps, at time 0.
Vec3 swept_normal(const MovingRing& ring, double angle) {
  const double h = 1e-6;
  const Vec3 along = (point(ring, angle, h) - point(ring, angle, -h)) / (2 * h);
  const Vec3 around = (point(ring, angle + h, 0) - point(ring, angle - h, 0)) / (2 * h);
  return around.cross(along).normalized();
}

template <class Function>
void expect_normals(const MovingRing& ring, const Function& expected) {
  for (double angle = 0; angle < 6; angle += .5) {
    const Vec3 n = swept_normal(ring, angle), wanted = expected(point(ring, angle, 0));
    EXPECT_NEAR(std::abs(n.dot(wanted)), 1, 1e-9) << angle;
  }
}

TEST(MovingRing, of_a_plate_grows_in_its_plane) {
  const MovingRing ring = along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, 2);
  EXPECT_EQ(ring.center_rate, Vec3(0, 0, 0));
  EXPECT_EQ(ring.radius_rate, 2);
}

TEST(MovingRing, along_a_canal_is_tangent_to_its_cone_however_it_turns) {
  for (const Vec3& rate : {Vec3(0, 0, 0), Vec3(kRing.normal.unitOrthogonal() * .4)}) {
    for (const double slope : {0., .3, -.5}) {
      const MovingRing ring = along_canal(kRing, slope, 2, rate);
      expect_normals(ring, [&](const Vec3& x) -> Vec3 {
        const Vec3 out = (x - kRing.center).normalized();
        return (out - slope * kRing.normal).normalized();
      });
      EXPECT_DOUBLE_EQ(ring.radius_rate, 2 * slope);
    }
  }
}

TEST(MovingRing, along_a_sphere_is_tangent_to_it) {
  const Vec3 center = kRing.center + .6 * kRing.normal;
  expect_normals(along_sphere(kRing, center, 3),
                 [&](const Vec3& x) -> Vec3 { return (x - center).normalized(); });
}

TEST(MovingRing, along_oblique_cones_and_cylinders_is_tangent_to_their_rulings) {
  const Vec3 behind = kRing.center - 2 * kRing.normal + .5 * kRing.normal.unitOrthogonal();
  const Vec3 ahead = kRing.center + 3 * kRing.normal + .5 * kRing.normal.unitOrthogonal();
  const auto along = [](const MovingRing& ring, const Vec3& apex) {
    for (double angle = 0; angle < 6; angle += .5) {
      const Vec3 ruling = (point(ring, angle, 0) - apex).normalized();
      EXPECT_NEAR(swept_normal(ring, angle).dot(ruling), 0, 1e-9);
    }
    EXPECT_GT(ring.center_rate.dot(kRing.normal), 0);  // onwards, whether it widens or not
  };
  const MovingRing widening = along_oblique_cone(kRing, behind, 1),
                   narrowing = along_oblique_cone(kRing, ahead, 1);
  along(widening, behind);
  along(narrowing, ahead);
  EXPECT_GT(widening.radius_rate, 0);
  EXPECT_LT(narrowing.radius_rate, 0);
  const Vec3 direction = kRing.normal + .7 * kRing.normal.unitOrthogonal();
  const MovingRing cylinder = along_oblique_cylinder(kRing, direction, 2);
  for (double angle = 0; angle < 6; angle += .5) {
    EXPECT_NEAR(swept_normal(cylinder, angle).dot(direction), 0, 1e-9);
  }
}

TEST(MovingRing, along_a_plate_shrinks_where_its_speed_is_negative) {
  const MovingRing ring = along_plate(kRing, -2);
  EXPECT_EQ(ring.radius_rate, -2);
  expect_normals(ring, [](const Vec3&) { return kRing.normal; });
}

TEST(MovingRing, needs_a_speed_and_a_circle) {
  for (const double speed : {0., -1., std::nan("")}) {
    EXPECT_THROW((void)along_canal(kRing, 0, speed), Error);
    EXPECT_THROW((void)along_oblique_cone(kRing, Vec3(0, 0, 0), speed), Error);
    EXPECT_THROW((void)along_oblique_cylinder(kRing, kRing.normal, speed), Error);
  }
  EXPECT_THROW((void)along_plate(kRing, 0), Error);
  EXPECT_THROW((void)along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 0}, 1), Error);
}

}  // namespace
}  // namespace dupin
