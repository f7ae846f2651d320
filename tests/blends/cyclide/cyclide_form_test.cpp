#include "dupin/blends/cyclide_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using std::numbers::pi;

// Normal curvature along the direction of a curve on the surface, from three of its points.
double measured_curvature(const Vec3& before, const Vec3& at, const Vec3& after,
                          const Vec3& normal) {
  const Vec3 u = at - before, v = after - at;
  const double h1 = u.norm(), h2 = v.norm();
  return -(v / h2 - u / h1).dot(normal) / ((h1 + h2) / 2);
}

TEST(PrincipalCurvatures, are_those_of_the_coordinate_lines) {
  test::RandomArcs arcs;
  for (int i = 0; i < 40; ++i) {
    const PeArc arc = arcs.next();
    const double h = 1e-4;
    for (const double v : {0.3, 2.0, 4.5}) {
      const ArcPoint at = point_at(arc, 0.4, v);
      const PrincipalCurvatures k = curvatures_at(arc, 0.4, v);
      const double along = measured_curvature(point_at(arc, 0.4 - h, v).position, at.position,
                                              point_at(arc, 0.4 + h, v).position, at.normal);
      EXPECT_NEAR(k.along, along, 1e-2 * (1 + std::abs(along)));
      EXPECT_EQ(k.around, 1 / sphere_at(arc, 0.4).r);
    }
  }
}

TEST(PrincipalCurvatures, of_a_torus_are_the_closed_forms) {
  const PeArc elbow = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                  test::sphere(3, 0, 3, 1));
  // v = 0 looks at the centre of the bend or away from it, pi the other way.
  const double inner = curvatures_at(elbow, 0.5, 0).along,
               outer = curvatures_at(elbow, 0.5, pi).along;
  EXPECT_NEAR(std::min(inner, outer), -1.0 / 2, 1e-13);
  EXPECT_NEAR(std::max(inner, outer), 1.0 / 4, 1e-13);
  EXPECT_NEAR(curvatures_at(elbow, 0.5, pi / 2).along, 0, 1e-13);
}

// The ball of the arc that reaches nearest to the point.
TEST(SignedDistance, is_that_of_the_nearest_ball) {
  test::RandomArcs arcs;
  for (int i = 0; i < 40; ++i) {
    const PeArc arc = arcs.next();
    const Vec3 point = arcs.vector();
    double sampled = 1e9;
    for (int k = 0; k <= 2000; ++k) {
      const PeVector ball = sphere_at(arc, k / 2000.);
      sampled = std::min(sampled, (ball.m - point).norm() - ball.r);
    }
    const double found = signed_distance(arc, point);
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_NEAR(found, sampled, 1e-2);
  }
}

TEST(LeastRadius, is_that_of_the_samples) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    double sampled = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      sampled = std::min(sampled, sphere_at(arc, k / 1000.).r);
    }
    EXPECT_LE(least_radius(arc), sampled * (1 + 1e-14));
    EXPECT_NEAR(least_radius(arc), sampled, 1e-3);
  }
}

TEST(CanonicalForm, names_are_those_of_the_kinds) {
  EXPECT_EQ(name(CyclideKind::torus), "torus");
  EXPECT_EQ(name(CyclideKind::hyperbolic), "hyperbolic cyclide");
}

}  // namespace
}  // namespace dupin
