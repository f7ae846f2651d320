#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assembly/parts/line_and_arc.h"
#include "dupin/blends/elliptic_tube.h"
#include "support/single_piece.h"

namespace dupin::assembly {
namespace {

using test::single_piece;

constexpr double kPi = std::numbers::pi;

TEST(LineAndArc, knows_no_minus_zero) {
  for (const Vec3& v : {plain(Vec3(-0.0, 1, -2)), opposite(Vec3(0.0, -1, 2))}) {
    EXPECT_EQ(v, Vec3(0, 1, -2));
    EXPECT_FALSE(std::signbit(v.x()));
  }
}

TEST(LineAndArc, quarter_turns_are_exact) {
  using Pair = std::pair<double, double>;
  EXPECT_EQ(cosine_and_sine(kPi / 2), Pair(0, 1));
  EXPECT_EQ(cosine_and_sine(kPi), Pair(-1, 0));
  EXPECT_EQ(cosine_and_sine(3 * kPi / 2), Pair(0, -1));
  for (const double angle : {0.1, 1.5, 1.6, 3.0, 6.2}) {
    const auto [cosine, sine] = cosine_and_sine(angle);
    EXPECT_EQ(cosine, std::cos(angle));
    EXPECT_EQ(sine, std::sin(angle));
  }
}

// From radius 2 to 5 over a length of 4.
TEST(LineAndArc, a_line_is_a_cone) {
  const Ring start{Vec3(1, 1, 1), Vec3(0, 0, -1), 2};
  const auto own = single_piece<RingedSurface>(line(start, Vec3(1, 1, 5), {5, {}}, true));
  EXPECT_EQ(own.start, (Ring{Vec3(1, 1, 1), Vec3(0, 0, -1), 2, -0.75}));
  EXPECT_EQ(own.end, (Ring{Vec3(1, 1, 5), Vec3(0, 0, 1), 5, 0.75}));
  EXPECT_NEAR(volume(own), kPi * 4 / 3 * (4 + 10 + 25), 1e-12);
  EXPECT_NEAR(area(own), kPi * (2 + 5) * 5, 1e-12) << "the slant is 5";
  const auto shared = single_piece<RingedSurface>(line(start, Vec3(1, 1, 5), {5, {}}, false));
  EXPECT_EQ(shared.start, start) << "bitwise the neighbour's";
  EXPECT_EQ(shared.end, own.end);
}

TEST(LineAndArc, a_cylinder_has_the_section_of_its_ring) {
  const Ring circle{Vec3::Zero(), Vec3(-1, 0, 0), 2, 0.5};
  const auto pipe = single_piece<RingedSurface>(cylinder(circle, Vec3(3, 0, 0)));
  EXPECT_EQ(pipe.start, circle);
  EXPECT_EQ(pipe.end, (Ring{Vec3(3, 0, 0), Vec3(1, 0, 0), 2}));
  EXPECT_EQ(pipe.radius, RadiusLaw(ConstantRadius{2}));
  const Ring ellipse{Vec3::Zero(), Vec3(-1, 0, 0), 2, 0, Ellipse{Vec3(0, 0, 1), 1}};
  const auto duct = single_piece<EllipticTube>(cylinder(ellipse, Vec3(3, 0, 0)));
  EXPECT_EQ(duct.end, (Ring{Vec3(3, 0, 0), Vec3(1, 0, 0), 2, 0, Ellipse{Vec3(0, 0, 1), 1}}));
  EXPECT_NEAR(volume(duct), kPi * 2 * 1 * 3, 1e-12);
}

// From a circle of radius 1 to semi-axes 3 and 2 over a length of 2: the integral of
// (1 + 2 t)(1 + t) over [0, 1] is 1 + 3/2 + 2/3.
TEST(LineAndArc, a_line_may_end_in_an_ellipse) {
  const Ring start{Vec3::Zero(), Vec3(0, 0, -1), 1};
  const EndSection section{3, Ellipse{Vec3(0, 1, 0), 2}};
  const auto cone = single_piece<EllipticTube>(line(start, Vec3(0, 0, 2), section, true));
  EXPECT_EQ(cone.end.slope, 1);
  EXPECT_EQ(cone.end.ellipse->across_slope, 0.5);
  EXPECT_EQ(cone.start.slope, -1);
  EXPECT_NEAR(volume(cone), kPi * 2 * (1 + 3.0 / 2 + 2.0 / 3), 1e-12);
}

// The third of a torus of radii 3 and 1 that leaves (3, 0, 0) along y, about the z axis.
TEST(LineAndArc, an_arc_is_a_part_of_a_torus) {
  const double angle = 2 * kPi / 3;
  const Vec3 out(std::cos(angle), std::sin(angle), 0), along(-out.y(), out.x(), 0);
  const Ring start{Vec3(3, 0, 0), Vec3(0, -1, 0), 1}, end{3 * out, along, 1};
  const auto bend = single_piece<RingedSurface>(arc(start, end, Vec3(-1, 0, 0), 3, angle));
  EXPECT_EQ(bend.start, start);
  EXPECT_EQ(bend.end, end);
  EXPECT_NEAR(volume(bend), kPi * 3 * angle, 1e-12) << "Pappus";
  for (const double t : {0.0, 0.25, 1.0}) {
    const SpinePoint point = evaluate(bend.spine, t);
    EXPECT_LT((point.position - 3 * Vec3(std::cos(t * angle), std::sin(t * angle), 0)).norm(),
              1e-15 * 4);
  }
}

// Its part along the bend's axis stays, the other one turns with the bend.
TEST(LineAndArc, an_arc_turns_the_axis_of_an_ellipse) {
  const Ring start{Vec3(3, 0, 0), Vec3(0, -1, 0), 1, 0, Ellipse{Vec3(0.6, 0, 0.8), 0.5}};
  const Ring end{Vec3(0, 3, 0), Vec3(-1, 0, 0), 1};
  const auto bend = single_piece<EllipticTube>(arc(start, end, Vec3(-1, 0, 0), 3, kPi / 2));
  ASSERT_TRUE(bend.end.ellipse);
  EXPECT_LT((bend.end.ellipse->axis - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(bend.end.ellipse->across, 0.5);
  EXPECT_NEAR(volume(bend), kPi * 0.5 * 3 * kPi / 2, 1e-12);
}

}  // namespace
}  // namespace dupin::assembly
