#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

TEST(BoundingCircles, have_the_oracle_values) {
  // Mathematics C4.
  const PeArc bow =
      through_three(test::sphere(0, 0, 0, 1), test::sphere(2, 1, 0, .8), test::sphere(4, 0, 0, 1));
  auto circles = bounding_circles(bow);
  std::sort(circles.begin(), circles.end(),
            [](const auto& a, const auto& b) { return a.radius > b.radius; });
  EXPECT_NEAR(circles[0].radius, 3.9, 1e-12);
  EXPECT_LT((circles[0].center - Vec3(2, -2.1, 0)).norm(), 1e-12);
  EXPECT_NEAR(circles[1].radius, -3.8 / 3, 1e-12);
  EXPECT_LT((circles[1].center - Vec3(2, -3.2 / 3, 0)).norm(), 1e-12);
  // A piece of revolution: both on the same side.
  const PeArc barrel = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), 0),
                                   test::sphere(3, 0, 0, .8));
  for (const BoundingCircle& circle : bounding_circles(barrel)) {
    EXPECT_NEAR(circle.radius, 23.4, 1e-11);
    EXPECT_NEAR(circle.center.norm(), 22.4, 1e-11);
  }
  const PeArc hourglass =
      through_three(test::sphere(0, 0, 0, 2), test::sphere(2, 0, 0, 1), test::sphere(4, 0, 0, 2));
  EXPECT_NEAR(bounding_circles(hourglass)[0].radius, -0.5, 1e-13);
}

// Both ways: the circles of a piece give the form that its spheres do, up to the sign of mu, with
// which x turns.
TEST(BoundingCircles, give_the_canonical_form_back) {
  test::RandomArcs arcs;
  int elliptic = 0, hyperbolic = 0;
  for (int i = 0; i < 600; ++i) {
    const PeArc arc = arcs.next();
    const CanonicalCyclide expected = canonical_form(arc);
    const auto [one, other] = bounding_circles(arc);
    const CanonicalCyclide found = canonical_form(one, other, frame(arc).second);
    EXPECT_EQ(found.kind, expected.kind);
    // Of regular pieces the signs tell the kind.
    EXPECT_EQ(one.radius * other.radius < 0, expected.kind == CyclideKind::elliptic);
    (expected.kind == CyclideKind::elliptic ? elliptic : hyperbolic)++;
    // Nearly straight pieces have large circles, which cancel.
    const double size =
        std::abs(one.radius) + std::abs(other.radius) + one.center.norm() + other.center.norm();
    const double tolerance = 1e-13 * size * size;
    EXPECT_NEAR(found.a, expected.a, tolerance);
    EXPECT_NEAR(found.c, expected.c, tolerance);
    EXPECT_NEAR(std::abs(found.mu), std::abs(expected.mu), tolerance);
    EXPECT_LT((found.origin - expected.origin).norm(), tolerance);
    for (const double v : {0.4, 2.5}) {
      const double value = implicit_value(found, point_at(arc, 0.3, v).position);
      EXPECT_LT(std::abs(value), tolerance * size * size) << i;
    }
  }
  EXPECT_GT(elliptic, 100);
  EXPECT_GT(hyperbolic, 5);
}

TEST(BoundingCircles, refuse_lines_and_equal_circles) {
  const PeArc cone = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                 test::sphere(0, 0, 4, 1));
  EXPECT_THROW((void)bounding_circles(cone), Error);
  EXPECT_THROW((void)canonical_form({Vec3::Zero(), 1}, {Vec3::Zero(), 1}, Vec3::UnitZ()), Error);
}

// The circles are where the plane of symmetry meets the surface, and touch every sphere.
TEST(BoundingCircles, touch_the_spheres_of_the_piece) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    for (const BoundingCircle& circle : bounding_circles(arc)) {
      for (const double t : {0., .3, .8, 1.}) {
        const PeVector ball = sphere_at(arc, t);
        const double size = std::abs(circle.radius) + ball.m.norm() + circle.center.norm();
        // Inside of a circle that encloses it, outside of one that does not.
        const double gap = (ball.m - circle.center).norm();
        EXPECT_NEAR(gap, std::abs(circle.radius - ball.r), 1e-11 * size);
      }
    }
  }
}

}  // namespace
}  // namespace dupin
