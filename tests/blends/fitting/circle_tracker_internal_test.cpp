#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/fitting/implicit_surfaces.h"
#include "dupin/kernel/error.h"
#include "fitting/circle_tracker.h"

namespace dupin::fitting {
namespace {

TEST(CircleTracker, finds_the_circles_of_a_torus_and_how_they_move) {
  const ImplicitSurface torus = test::torus(5, 1);
  const TravelRing guess{{5.1, 0, 0.1}, Vec3(0.1, 1, -0.1).normalized(), 1.2};
  const auto [ring, defect] = circle_near(torus, guess, Vec3::UnitY());
  EXPECT_LT((ring.center - Vec3(5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((ring.normal - Vec3::UnitY()).norm(), 1e-6);  // tilts matter to the second order
  EXPECT_NEAR(ring.radius, 1, 1e-12);
  EXPECT_LT((ring.center_rate - Vec3::UnitY()).norm(), 1e-6);
  EXPECT_LT((ring.normal_rate - Vec3(-0.2, 0, 0)).norm(), 1e-5);  // 1 / bend radius
  EXPECT_NEAR(ring.radius_rate, 0, 1e-8);
  EXPECT_LT(defect, 1e-12);
}

// [mathematics B1]: spheres about (a cos, b sin, 0) of radius mu - c cos touch it in circles.
TEST(CircleTracker, finds_the_circles_of_a_cyclide) {
  const double a = 5, c = 1, mu = 2, b = std::sqrt(a * a - c * c);
  const ImplicitSurface cyclide = test::cyclide(a, c, mu);
  for (const double angle : {0.3, 1.2, 2.5}) {
    const Vec3 center(a * std::cos(angle), b * std::sin(angle), 0);
    const Vec3 along = Vec3(-a * std::sin(angle), b * std::cos(angle), 0).normalized();
    const double radius = mu - c * std::cos(angle);
    const TrackedCircle found = circle_near(cyclide, {center, along, radius}, along);
    EXPECT_LT(found.defect, 1e-12);
    for (int k = 0; k < 7; ++k) {
      const Vec3 first = found.ring.normal.unitOrthogonal();
      const Vec3 out = std::cos(k) * first + std::sin(k) * found.ring.normal.cross(first);
      EXPECT_LT(first_order_distance(cyclide, found.ring.center + found.ring.radius * out), 1e-12);
    }
    // The motion that is predicted is where the circles go.
    constexpr double kStep = 1e-3;
    const MovingRing& ring = found.ring;
    const TrackedCircle next =
        circle_near(cyclide, {ring.center + kStep * ring.center_rate, ring.normal, ring.radius},
                    ring.center_rate);
    EXPECT_LT(((next.ring.center - ring.center) / kStep - ring.center_rate).norm(), 2e-3);
    EXPECT_LT(((next.ring.normal - ring.normal) / kStep - ring.normal_rate).norm(), 2e-3);
    EXPECT_NEAR((next.ring.radius - ring.radius) / kStep, ring.radius_rate, 1e-3);
  }
}

TEST(CircleTracker, takes_the_nearest_of_a_sphere) {
  const TrackedCircle found =
      circle_near(test::sphere(2), {{0, 0, 1}, Vec3::UnitZ(), 1.5}, Vec3::UnitZ());
  EXPECT_NEAR(found.ring.radius, std::sqrt(3), 1e-12);
  EXPECT_LT(found.defect, 1e-12);
}

TEST(CircleTracker, measures_how_far_a_surface_is_from_ringed) {
  const TrackedCircle found =
      circle_near(test::torus(5, 1, 1.3), {{5, 0, 0}, Vec3::UnitY(), 1}, Vec3::UnitY());
  EXPECT_GT(found.defect, 0.05);  // of sections with semi-axes 1 and 1.3
  EXPECT_LT(found.defect, 0.2);
}

TEST(CircleTracker, says_where_there_is_none) {
  const ImplicitSurface flat{[](const Vec3&) { return 1.; },
                             [](const Vec3&) { return Vec3(0, 0, 0); }};
  EXPECT_THROW((void)circle_near(flat, {{0, 0, 0}, Vec3::UnitX(), 1}, Vec3::UnitX()), Error);
  EXPECT_EQ(first_order_distance(flat, {0, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace dupin::fitting
