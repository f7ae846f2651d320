#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
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

// The spheres of the piece are those that the parametrisation says.
TEST(CanonicalPiece, runs_along_the_ellipse_the_hyperbola_and_the_parabola) {
  CanonicalCyclide form = ring_cyclide(3, 1, 2);
  form.origin = Vec3::Zero();
  form.x = Vec3::UnitX();
  form.y = Vec3::UnitY();
  form.z = Vec3::UnitZ();
  const PeArc ellipse = arc_of({form, false, .25, 1.5});
  EXPECT_LT(distance(ellipse.start(),
                     {Vec3(3 * std::cos(.25), form.b * std::sin(.25), 0), 2 - std::cos(.25)}),
            1e-14);
  EXPECT_LT(distance(ellipse.end(),
                     {Vec3(3 * std::cos(1.5), form.b * std::sin(1.5), 0), 2 - std::cos(1.5)}),
            1e-14);
  // All between them on the ellipse too.
  for (const double t : {.25, .5, .75}) {
    const PeVector ball = sphere_at(ellipse, t);
    EXPECT_NEAR(std::pow(ball.m.x() / 3, 2) + std::pow(ball.m.y() / form.b, 2), 1, 1e-13);
    EXPECT_NEAR(ball.r, 2 - ball.m.x() / 3, 1e-13);
  }
  form.kind = CyclideKind::parabolic;
  form.a = 4;
  const PeArc parabola = arc_of({form, false, -.5, 1});
  EXPECT_LT(distance(parabola.start(), {Vec3(.03125, -.5, 0), 2 - .03125}), 1e-14);
  EXPECT_LT(distance(parabola.end(), {Vec3(.125, 1, 0), 2 - .125}), 1e-14);
}

TEST(CanonicalPiece, runs_backwards_where_its_parameters_fall) {
  const CanonicalCyclide form = ring_cyclide(3, 1, 2);
  const PeArc there = arc_of({form, false, .25, 1.5}), back = arc_of({form, false, 1.5, .25});
  EXPECT_EQ(there.start(), back.end());
  EXPECT_EQ(there.end(), back.start());
  EXPECT_LT(distance(there.start_tangent(), -1 * back.end_tangent()), 1e-14);
}

}  // namespace
}  // namespace dupin
