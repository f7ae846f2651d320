#include "dupin/blends/cyclide_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/bounding_circles.h"
#include "dupin/blends/cyclide_chain.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using std::numbers::pi;

double distance(const PeVector& a, const PeVector& b) {
  return std::hypot((a.m - b.m).norm(), a.r - b.r);
}

CanonicalCyclide ring_cyclide(double a, double c, double mu) {
  return {CyclideKind::elliptic,
          a,
          std::sqrt(a * a - c * c),
          c,
          mu,
          Vec3(1, 2, 3),
          Vec3::UnitY(),
          Vec3::UnitZ(),
          Vec3::UnitX()};
}

TEST(CanonicalPiece, quarters_of_a_ring_cyclide_have_the_oracle_sums) {
  struct Row {
    double a, c, mu, area, volume;
  };
  for (const Row& row : {Row{3, 1, 2, 243.497262034861, 272.688921583666},
                         Row{4, 1.5, 2.5, 408.789833518455, 598.223596395124}}) {
    double area_sum = 0, volume_sum = 0;
    for (int i = 0; i < 4; ++i) {
      const PeArc arc =
          arc_of({ring_cyclide(row.a, row.c, row.mu), false, i * pi / 2, (i + 1) * pi / 2});
      area_sum += area(arc);
      volume_sum += volume(arc);
    }
    EXPECT_NEAR(area_sum, row.area, 1e-12 * row.area);
    EXPECT_NEAR(volume_sum, row.volume, 1e-12 * row.volume);
  }
}

TEST(CanonicalPiece, leads_there_and_back) {
  test::RandomArcs arcs;
  int hyperbolic = 0;
  for (int i = 0; i < 300; ++i) {
    const PeArc arc = arcs.next();
    const CanonicalPiece piece = canonical_piece(arc);
    const PeArc back = arc_of(piece);
    hyperbolic += piece.along_hyperbola ? 1 : 0;
    // The forms of nearly straight pieces are large, and cancel.
    const double size = std::abs(piece.form.a) + std::abs(piece.form.mu) + 10;
    const double tolerance = 1e-13 * size * size;
    EXPECT_LT(distance(back.start(), arc.start()), tolerance);
    EXPECT_LT(distance(back.end(), arc.end()), tolerance);
    EXPECT_LT(distance(back.start_tangent(), arc.start_tangent()), tolerance);
  }
  EXPECT_GT(hyperbolic, 0);
}

TEST(CanonicalPiece, parabolic_pieces_lead_there_and_back) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 2), test::direction(Vec3::UnitX(), 0),
                                test::sphere(2, .6, 0, 1.4));
  const CanonicalPiece piece = canonical_piece(arc);
  EXPECT_NEAR(piece.form.a, 10.0 / 3, 1e-12);
  EXPECT_NEAR(piece.from, 0, 1e-14);
  EXPECT_NEAR(piece.to, 2, 1e-14);
  EXPECT_LT(distance(arc_of(piece).end_tangent(), arc.end_tangent()), 1e-12);
}

TEST(CanonicalPiece, more_than_half_turns_keep_their_way) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                test::sphere(3, 0, -3, 1));
  const CanonicalPiece piece = canonical_piece(arc);
  EXPECT_NEAR(std::abs(piece.to - piece.from), 1.5 * pi, 1e-12);
  EXPECT_NEAR(area(arc_of(piece)), area(arc), 1e-11 * area(arc));
}

TEST(CanonicalPiece, refuses_what_has_none) {
  const PeArc cone = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), .25),
                                 test::sphere(0, 0, 4, 2));
  EXPECT_THROW((void)canonical_piece(cone), Error);
  EXPECT_THROW((void)arc_of({ring_cyclide(3, 1, 2), false, 0, 7}), Error);
  EXPECT_THROW((void)arc_of({ring_cyclide(3, 1, 2), false, 1, 1}), Error);
  EXPECT_THROW((void)arc_of({ring_cyclide(3, 1, 2), true, 0, 3}), Error);
}

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

}  // namespace
}  // namespace dupin
