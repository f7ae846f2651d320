#include "dupin/blends/tangency.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Fig. 6 between cones of the signed half angles (in the direction of travel), or cylinders.
RingedSurface between_cones(double start_angle, double end_angle, const RadiusLaw& radius) {
  RingedSurface surface = test::figure6(radius);
  surface.start.slope = -std::tan(start_angle);  // seen from the normal, which looks back
  surface.end.slope = std::tan(end_angle);
  return surface;
}

TEST(Tangency, of_a_cubic_spine_against_cones_is_the_oracles_deviation) {
  const double from = 5 * kDegree, to = -8 * kDegree;
  // R' = |y'| tan(half angle) at the end looked at, by a linear law.
  const Tangency start =
      tangency_at_end(between_cones(from, 0, LinearRadius{1, 1 + 10 * std::tan(from)}), End::start);
  EXPECT_NEAR(start.deviation.lower / kDegree, 3.616207249, 5e-10);
  EXPECT_NEAR(start.deviation.upper / kDegree, 3.616207249, 5e-10);
  EXPECT_NEAR(start.curvature_times_radius.lower, 0.422612858, 5e-10);
  const Tangency end =
      tangency_at_end(between_cones(0, to, LinearRadius{2 - 20 * std::tan(to), 2}), End::end);
  EXPECT_NEAR(end.deviation.lower / kDegree, 2.333967035, 5e-10);
  EXPECT_NEAR(end.deviation.upper / kDegree, 2.333967035, 5e-10);
  EXPECT_NEAR(end.curvature_times_radius.upper, 0.229251370, 5e-10);
  for (const Tangency& t : {start, end}) {
    EXPECT_LT(t.deviation.lower, t.deviation.upper);  // no double is that angle
    EXPECT_EQ(t.deviation.upper, std::nextafter(t.deviation.lower, 1));
  }
}

/// Degree n coefficients with the slopes of the cones at both ends, for end speeds 10 and 20.
BezierRadius cone_to_cone(double start_angle, double end_angle, int n) {
  BezierRadius law;
  for (int i = 0; i <= n; ++i) {
    law.coefficients.push_back(2 * i < n ? 1 + i * 10 * std::tan(start_angle) / n
                                         : 2 - (n - i) * 20 * std::tan(end_angle) / n);
  }
  return law;
}

TEST(Tangency, of_quintic_and_septic_spines_against_cones_is_rounding_only) {
  const double from = 5 * kDegree, to = -8 * kDegree;
  const HermiteSpine cubic = test::skew_spine(10, 20);
  for (const BezierSpine& spine : {quintic_spine(cubic), septic_spine(cubic)}) {
    const int degree = static_cast<int>(spine.points.size()) - 1;
    RingedSurface surface = between_cones(from, to, cone_to_cone(from, to, degree));
    surface.spine = spine;
    for (const End end : {End::start, End::end}) {
      const Tangency t = tangency_at_end(surface, end);
      // Coordinates up to 10 are rounded to 2^-50, steps between points are no shorter than 1.
      EXPECT_LT(t.deviation.upper, degree * 0x1p-50);
      EXPECT_LT(t.axis_angle.upper, degree * 0x1p-50);
    }
    EXPECT_EQ(tangency_at_end(surface, End::start).curvature_times_radius, (Enclosure{0, 0}));
  }
}

TEST(Tangency, of_a_rational_quarter_circle_is_that_of_the_arc) {
  const BezierSpine quarter{{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 3, 0)}, {1, std::sqrt(0.5), 1}};
  const RingedSurface elbow{{Vec3::Zero(), -Vec3::UnitX(), 1},
                            {Vec3(3, 3, 0), Vec3::UnitY(), 1},
                            quarter,
                            ConstantRadius{1}};
  for (const End end : {End::start, End::end}) {
    const Tangency t = tangency_at_end(elbow, end);
    EXPECT_TRUE(t.exact());
    EXPECT_NEAR(t.curvature_times_radius.lower, 1.0 / 3, 1e-15);  // the weight is rounded
  }
}

TEST(Tangency, with_slope_zero_against_cylinders_is_exact) {
  for (const RadiusLaw& law : {RadiusLaw(CubicRadius{1, 2}), RadiusLaw(CyclideRadius{1, 2}),
                               RadiusLaw(ConstantRadius{1})}) {
    for (const End end : {End::start, End::end}) {
      EXPECT_EQ(tangency_at_end(test::figure6(law), end).deviation, (Enclosure{0, 0}));
    }
  }
  EXPECT_TRUE(tangency_at_end(test::figure6(), End::start).exact());
}

TEST(Tangency, tells_a_velocity_one_ulp_off_the_stored_normal) {
  RingedSurface surface = test::figure6();
  std::get<HermiteSpine>(surface.spine).start_velocity.y() = 10 * 0x1p-52;
  const Tangency t = tangency_at_end(surface, End::start);
  EXPECT_EQ(t.deviation, (Enclosure{0, 0}));
  EXPECT_FALSE(t.exact());
  // The arc tangent of 2^-52 lies within an ulp below it.
  EXPECT_EQ(t.axis_angle.upper, 0x1p-52);
  EXPECT_EQ(t.axis_angle.lower, std::nextafter(0x1p-52, 0));
}

TEST(Tangency, of_a_skew_end_encloses_the_rounding_of_its_direction) {
  const Tangency t = tangency_at_end(test::figure6(), End::end);
  EXPECT_LE(t.axis_angle.upper, 4 * std::numeric_limits<double>::epsilon());
}

TEST(Tangency, against_a_cone_with_a_straight_spine_is_the_difference_of_the_angles) {
  const Vec3 x = Vec3::UnitX();
  const LineSpine line{Vec3::Zero(), 4 * x};
  RingedSurface cone{{Vec3::Zero(), -x, 1, -0.25}, {4 * x, x, 2, 0.25}, line, LinearRadius{1, 2}};
  EXPECT_TRUE(tangency_at_end(cone, End::start).exact());
  EXPECT_TRUE(tangency_at_end(cone, End::end).exact());
  cone.end.slope = 0;
  const Enclosure edge = tangency_at_end(cone, End::end).deviation;
  EXPECT_LE(edge.lower, std::atan(0.25));
  EXPECT_GE(edge.upper, std::atan(0.25));
  EXPECT_LE(edge.upper, std::nextafter(edge.lower, 1));
}

TEST(Tangency, of_an_elbow_is_exact_but_for_the_rounding_of_its_directions) {
  const double quarter = std::numbers::pi / 2;
  const ArcSpine arc{Vec3(0, 3, 0), Vec3::UnitZ(), Vec3::Zero(), quarter};
  const RingedSurface elbow{
      {Vec3::Zero(), -Vec3::UnitX(), 1}, {Vec3(3, 3, 0), Vec3::UnitY(), 1}, arc, ConstantRadius{1}};
  const Tangency start = tangency_at_end(elbow, End::start);
  EXPECT_TRUE(start.exact());
  EXPECT_LE(start.curvature_times_radius.lower, 1.0 / 3);
  EXPECT_GE(start.curvature_times_radius.upper, 1.0 / 3);
  const Tangency end = tangency_at_end(elbow, End::end);
  EXPECT_EQ(end.deviation, (Enclosure{0, 0}));
  // pi / 2 as a double falls short of a quarter turn by 6.123e-17.
  EXPECT_NEAR(end.axis_angle.lower, std::cos(quarter), 1e-30);
}

TEST(Tangency, of_a_folded_end_is_half_a_turn) {
  RingedSurface folded = test::figure6(CubicRadius{3, 3});  // kappa R = 1.27 at the start
  const Tangency t = tangency_at_end(folded, End::start);
  EXPECT_GT(t.curvature_times_radius.lower, 1);
  EXPECT_LE(t.deviation.lower, std::numbers::pi);
  EXPECT_GE(t.deviation.upper, std::numbers::pi);
}

TEST(Tangency, of_a_spine_that_stands_still_is_refused) {
  RingedSurface stuck = test::figure6();
  std::get<HermiteSpine>(stuck.spine).start_velocity = Vec3::Zero();
  try {
    (void)tangency_at_end(stuck, End::start);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    EXPECT_EQ(error.where(), "start");
  }
}

}  // namespace
}  // namespace dupin
