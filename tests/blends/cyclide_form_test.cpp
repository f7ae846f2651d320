#include "dupin/blends/cyclide_form.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

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
