#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cyclide/complementary_sphere.h"
#include "support/cyclide_cases.h"

namespace dupin::cyclide {
namespace {

// Spheres of the two families touch: the distance of the centres is the difference of the signed
// radii.
TEST(ComplementarySphere, touches_every_sphere_of_the_piece) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    const ArcFrame axes = frame(arc);
    for (const double v : {0., 1., 2.5, 4.}) {
      const ComplementarySphere q = complementary_sphere(arc, axes, 1, std::cos(v), std::sin(v));
      for (const double t : {0., .3, 1.}) {
        const PeVector ball = sphere_at(arc, t);
        // (m - c)^2 = (r - R)^2, times the squared weight: true of planes too.
        const double apart = (q.weight * ball.m - q.center).squaredNorm();
        const double radii = q.weight * ball.r - q.radius;
        const double size =
            q.weight * q.weight * ball.m.squaredNorm() + q.center.squaredNorm() + radii * radii;
        EXPECT_NEAR(apart, radii * radii, 1e-11 * size);
      }
    }
  }
}

TEST(ComplementarySphere, touches_along_the_line_of_curvature) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    const ArcFrame axes = frame(arc);
    for (const double v : {.5, 3.}) {
      const ComplementarySphere q = complementary_sphere(arc, axes, 1, std::cos(v), std::sin(v));
      for (const double t : {0., .4, 1.}) {
        const ArcPoint p = point_at(arc, t, v);
        EXPECT_NEAR((q.weight * p.position - q.center).norm(), std::abs(q.radius),
                    1e-8 * (std::abs(q.radius) + std::abs(q.weight)));
        // In the direction of the piece's normal.
        const Vec3 across = (q.weight * p.position - q.center).normalized();
        EXPECT_NEAR(std::abs(across.dot(p.normal)), 1, 1e-7);
      }
    }
  }
}

TEST(ComplementarySphere, is_bilinear_in_the_ring_coordinates) {
  test::RandomArcs arcs;
  const PeArc arc = arcs.next();
  const ArcFrame axes = frame(arc);
  const auto at = [&](double kappa, double c, double s) {
    return complementary_sphere(arc, axes, kappa, c, s);
  };
  const ComplementarySphere a = at(1, .6, .8), b = at(2, 1, -1), sum = at(3, 1.6, -.2);
  EXPECT_LT((a.center + b.center - sum.center).norm(), 1e-12);
  EXPECT_NEAR(a.radius + b.radius, sum.radius, 1e-12);
  EXPECT_NEAR(a.weight + b.weight, sum.weight, 1e-12);
}

TEST(ComplementarySphere, of_a_cylinder_is_a_plane) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                test::sphere(0, 0, 4, 1));
  const ComplementarySphere q = complementary_sphere(arc, frame(arc), 1, .6, .8);
  EXPECT_EQ(q.weight, 0);
  EXPECT_GT(q.center.norm(), 0);
}

}  // namespace
}  // namespace dupin::cyclide
