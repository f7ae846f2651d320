#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "junction/separation.h"

namespace dupin::junction {
namespace {

constexpr std::array kBoth{Arithmetic::exact, Arithmetic::rounded};

// Of a pipe from this place to the hub about the origin.
JunctionArm arm(const Vec3& from, const Vec3& travel, double radius, double hub) {
  const Ring end{from, travel.normalized(), radius};
  return {end, {}, PeArc::from(contact_sphere(end), contact_tangent(end), {Vec3(0, 0, 0), hub})};
}

JunctionArm in_plane(double degrees, double hub) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec3 direction(std::cos(angle), std::sin(angle), 0);
  return arm(4 * direction, -direction, 1, hub);
}

// Table C11: caps of cylinders r = 1 at 120 degrees, h = 4, touch for R = 1 + 4 tan 15 degrees.
TEST(Caps, are_disjoint_from_the_touch_on) {
  const double least = 1 + 4 * std::tan(std::numbers::pi / 12);
  for (const Arithmetic arithmetic : kBoth) {
    for (const double step : {1e-6, 1e-12}) {
      const double above = least * (1 + step), below = least * (1 - step);
      EXPECT_TRUE(
          caps_are_disjoint(in_plane(0, above).collar, in_plane(120, above).collar, arithmetic));
      EXPECT_FALSE(
          caps_are_disjoint(in_plane(0, below).collar, in_plane(120, below).collar, arithmetic));
    }
  }
  EXPECT_NEAR(cap_gap(in_plane(0, least).collar, in_plane(120, least).collar), 0, 1e-14);
}

// Caps of more than a hemisphere together contain each other's complement: no angle between axes
// makes them disjoint.
TEST(Caps, of_more_than_the_sphere_overlap) {
  const Vec3 x = Vec3::UnitX();
  const JunctionArm a = arm(-4 * x, x, 3, 2.5), b = arm(4 * x, -x, 3, 2.5);
  EXPECT_GT(cap_angle(a), std::numbers::pi / 2);
  for (const Arithmetic arithmetic : kBoth) {
    EXPECT_FALSE(caps_are_disjoint(a.collar, b.collar, arithmetic));
  }
}

TEST(Arms, are_apart_where_a_plane_tells_them) {
  for (const Arithmetic arithmetic : kBoth) {
    EXPECT_TRUE(arms_are_apart(in_plane(0, 2.3), in_plane(120, 2.3), arithmetic));
    EXPECT_TRUE(arms_are_apart(in_plane(0, 2.3), in_plane(180, 2.3), arithmetic));
    EXPECT_FALSE(arms_are_apart(in_plane(0, 1.8), in_plane(100, 1.8), arithmetic));
  }
}

// A pipe that comes from behind the other one's plane bends towards a cap that is free.
TEST(Arms, are_not_apart_where_one_crosses_the_planes) {
  const JunctionArm straight = in_plane(0, 2.3);
  const JunctionArm other = arm(Vec3(9, 9, 0), Vec3(-1, 0.2, 0), 1, 2.3);
  for (const Arithmetic arithmetic : kBoth) {
    EXPECT_FALSE(arms_are_apart(straight, other, arithmetic));
  }
}

TEST(Collars, go_forward_unless_they_turn_by_more_than_half_a_circle) {
  for (const Arithmetic arithmetic : kBoth) {
    EXPECT_TRUE(goes_forward(in_plane(0, 2.3).collar, arithmetic));
    EXPECT_FALSE(goes_forward(arm(Vec3(-1, 9, 0), Vec3(-1, 0.01, 0), 1, 2.3).collar, arithmetic));
  }
}

TEST(Cones, approach_the_hub_unless_they_pass_it) {
  for (const Arithmetic arithmetic : kBoth) {
    EXPECT_TRUE(approaches(in_plane(0, 2.3).collar, arithmetic));
    EXPECT_FALSE(approaches(arm(Vec3(1, 9, 0), Vec3(1, 0, 0), 1, 2.3).collar, arithmetic));
  }
}

}  // namespace
}  // namespace dupin::junction
