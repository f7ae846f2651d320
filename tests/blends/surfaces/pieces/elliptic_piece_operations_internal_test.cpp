#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "surfaces/pieces/elliptic_piece_operations.h"
#include "tessellation/swept_mesh.h"

namespace dupin::surfaces {
namespace {

constexpr double kLength = 6;

Vec3 turned(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

// Along the z axis, the first semi-axis beginning along x and turning by so much.
EllipticTube upright(const RadiusLaw& first, const RadiusLaw& second, double turn,
                     Continuity continuity = Continuity::g1) {
  const auto ring = [&](double t) {
    return Ring{Vec3(0, 0, t * kLength), Vec3(0, 0, t == 0 ? -1 : 1), evaluate(first, t).value, 0,
                Ellipse{turned(turn * t), evaluate(second, t).value}};
  };
  EllipticTube tube{ring(0), ring(1), LineSpine{Vec3(0, 0, 0), Vec3(0, 0, kLength)}, first, second};
  tube.turn = turn;
  tube.continuity = continuity;
  return tube;
}

// The surface at a height is one ellipse; a linear estimate of the distance from it in its plane.
double off_surface(const EllipticTube& tube, const Vec3& x) {
  const double t = x.z() / kLength;
  const double eased = tube.continuity == Continuity::g1
                           ? 3 * t * t - 2 * t * t * t
                           : 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3);
  const double a = evaluate(tube.first, t).value, b = evaluate(tube.second, t).value;
  const Vec3 axis = turned(tube.turn * eased);
  const double u = x.dot(axis), v = x.dot(Vec3::UnitZ().cross(axis));
  const double value = u * u / (a * a) + v * v / (b * b) - 1;
  return value / (2 * std::hypot(u / (a * a), v / (b * b)));
}

TEST(EllipticPieceOperations, rows_turn_as_the_continuity_eases_them) {
  for (const Continuity continuity : {Continuity::g1, Continuity::g2}) {
    const EllipticTube tube = upright(CubicRadius{2, 1.5}, LinearRadius{1, 1.2}, 1.2, continuity);
    const RingSampling sampling{segments_for(tube, .01, 0), .3};
    const Tessellation found = surfaces::tessellate(tube, sampling, {.01});
    EXPECT_LE(found.error_bound, .01);
    for (const Vec3& point : found.mesh.points) {
      EXPECT_LT(std::abs(off_surface(tube, point)), 1e-12);
    }
    double largest = 0;
    for (const auto& [a, b, c] : found.mesh.triangles) {
      const Vec3 &p = found.mesh.points[a], &q = found.mesh.points[b], &r = found.mesh.points[c];
      for (const Vec3& x : {Vec3((p + q + r) / 3), Vec3((p + q) / 2), Vec3((p + r) / 2)}) {
        largest = std::max(largest, std::abs(off_surface(tube, x)));
      }
    }
    EXPECT_LE(largest, found.error_bound);
    EXPECT_GE(largest, found.error_bound / 5);
  }
}

// What axes are off by counts, too, which segments were chosen without.
TEST(EllipticPieceOperations, keeps_to_the_tolerance_where_axes_are_carried) {
  for (const double turn : {0.0, 0.4, 1.2}) {
    for (const double tolerance : {0.05, 0.0123, 0.004, 0.0032, 0.0028, 0.0011, 0.0009}) {
      for (const double radius : {1.3, 2.0, 4.7}) {
        SCOPED_TRACE(testing::Message() << turn << ' ' << tolerance << ' ' << radius);
        const EllipticTube tube = upright(CubicRadius{radius, 1.5}, LinearRadius{1, 1.2}, turn);
        const Tessellation found =
            surfaces::tessellate(tube, {segments_for(tube, tolerance, 0)}, {tolerance});
        EXPECT_LE(found.error_bound, tolerance);
        EXPECT_GE(found.error_bound, tolerance / 2);
        const Ring ring{Vec3(3, 0, 0), Vec3(0, -1, 0), radius / 2, 0,
                        Ellipse{Vec3::UnitZ(), radius / 3}};
        const Ring other{Vec3(0, 3, 0), Vec3(-1, 0, 0), radius / 2, 0,
                         Ellipse{Vec3::UnitZ(), radius / 3}};
        EllipticTube bend{ring, other,
                          ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(3, 0, 0), std::acos(0.0)},
                          ConstantRadius{radius / 2}, ConstantRadius{radius / 3}};
        bend.axis = Vec3::UnitZ();
        const Tessellation bent =
            surfaces::tessellate(bend, {segments_for(bend, tolerance, 0)}, {tolerance});
        EXPECT_LE(bent.error_bound, tolerance);
      }
    }
  }
}

TEST(EllipticPieceOperations, plane_quadrilaterals_take_one_band) {
  struct Row {
    EllipticTube tube;
    bool one;
  };
  EllipticTube circle = upright(ConstantRadius{2}, ConstantRadius{2}, 0);
  circle.end.ellipse.reset();
  const Row rows[] = {
      {upright(ConstantRadius{2}, ConstantRadius{1}, 0), true},
      {upright(LinearRadius{2, 4}, LinearRadius{1, 2}, 0), true},
      {upright(LinearRadius{2, 4}, LinearRadius{1, 3}, 0), false},  // not similar
      {upright(CubicRadius{2, 4}, CubicRadius{1, 2}, 0), false},
      {upright(ConstantRadius{2}, ConstantRadius{1}, .1), false},
      {circle, false},  // whose polygon begins elsewhere
  };
  constexpr double kTolerance = .01;
  for (const Row& row : rows) {
    SCOPED_TRACE(&row - rows);
    const RingSampling sampling{segments_for(row.tube, kTolerance, 0)};
    const Tessellation found = surfaces::tessellate(row.tube, sampling, {kTolerance});
    EXPECT_LE(found.error_bound, kTolerance);
    EXPECT_EQ(found.knots.size(), found.bands + 1);
    EXPECT_EQ(found.axes == 0, row.one) << "of stored rings";
    if (row.one) {
      EXPECT_EQ(found.bands, 1U);
      // As few segments as chords permit, of the circle about the largest ellipse.
      const double radius = std::max(row.tube.start.radius, row.tube.end.radius);
      EXPECT_GT(tessellation::sagitta(radius, sampling.segments - 1), kTolerance * (1 - 1e-9));
      EXPECT_NEAR(found.error_bound, tessellation::sagitta(radius, sampling.segments), 1e-12);
    }
  }
}

TEST(EllipticPieceOperations, discs_and_margins_are_those_of_the_larger_semi_axis) {
  EllipticTube tube;
  tube.spine = ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 2};
  tube.start = {Vec3(4, 0, 0), -Vec3::UnitY(), 1, 0, Ellipse{Vec3::UnitX(), 2}};
  tube.end = {4 * turned(2), Vec3::UnitZ().cross(turned(2)), 1, 0, Ellipse{turned(2), 2}};
  tube.first = ConstantRadius{1};
  tube.second = ConstantRadius{2};
  EXPECT_FALSE(discs(tube).full);
  EXPECT_NEAR(discs(tube).hull({0, 1}).radius.upper, 2, 1e-12);
  const MarginBounds bounds = margin_bounds(tube);
  EXPECT_LE(bounds.lower, .5);
  EXPECT_NEAR(bounds.lower, .5, 1e-5);
  EXPECT_TRUE(bounds.regular);
  EXPECT_NEAR(nearly_largest_margin(tube, 0), .5, 1e-3);
  EXPECT_EQ(prove_margin(tube, 0, .499).verdict, Verdict::proved);
  // Of the circles; the ellipses themselves may do better.
  EXPECT_EQ(prove_margin(tube, 0, .501).verdict, Verdict::undecided);
  tube.first = ConstantRadius{4.5};
  EXPECT_FALSE(margin_bounds(tube).regular);
}

TEST(EllipticPieceOperations, claims_what_each_semi_axis_is_off) {
  EllipticTube tube = upright(ConstantRadius{2}, ConstantRadius{1}, 0);
  EXPECT_LT(tangency_claim(tube, End::end).offset, 1e-100);
  EXPECT_EQ(tangency_claim(tube, End::end).deviation, 0);
  tube.end.radius += .01;
  tube.end.ellipse->across -= .02;
  EXPECT_NEAR(tangency_claim(tube, End::end).offset, .03, 1e-14);
  tube.end.ellipse->across_slope = .25;
  const double deviation = tangency_claim(tube, End::end).deviation.value();
  EXPECT_GE(deviation, std::atan(.25) * (1 - 1e-12));
  EXPECT_LE(deviation, .5);
  EXPECT_NEAR(tangency(tube, End::end).value(), deviation, 1e-5);
  EXPECT_FALSE(tangency_claim(tube, End::end).curvature.has_value());
  EXPECT_EQ(extent(tube, 0).smallest, std::numeric_limits<double>::infinity());
}

TEST(EllipticPieceOperations, nurbs_are_exact_unless_the_axes_turn) {
  EXPECT_EQ(surfaces::nurbs(upright(CubicRadius{2, 1}, ConstantRadius{1}, 0), .01).error_bound, 0);
  const EllipticTube turning = upright(CubicRadius{2, 1}, ConstantRadius{1}, .5);
  const NurbsForm lofted = surfaces::nurbs(turning, .01);
  EXPECT_GT(lofted.error_bound, 0);
  EXPECT_LE(lofted.error_bound, .01);
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const Vec3 point = evaluate(lofted.surfaces.front(), i / 20., j / 20.);
      EXPECT_LE(std::abs(off_surface(turning, point)), 1.1 * lofted.error_bound);
    }
  }
}

}  // namespace
}  // namespace dupin::surfaces
