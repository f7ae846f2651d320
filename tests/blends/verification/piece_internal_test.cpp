#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "verification/admitted.h"
#include "verification/piece.h"

namespace dupin::verification {
namespace {

std::vector<dupin::Piece> one_of_each_kind() {
  const RingedSurface pipe = test::cylinder({0, 0, 0}, {3, 1, 2}, 1);
  EllipticTube oval{pipe.start, pipe.end, pipe.spine, ConstantRadius{1}, ConstantRadius{.5}};
  const Vec3 across = pipe.end.normal.unitOrthogonal();
  oval.start.ellipse = oval.end.ellipse = Ellipse{across, .5, 0};
  return {pipe, oval, test::cyclide_piece(test::crane_hook().pieces.front()),
          oblique_tube({0, 0, 0}, {1, 0, 3}, Vec3::UnitZ(), 1, 2)};
}

double upper(const Wide& x) { return x.rounded_outward().upper; }
double lower(const Wide& x) { return x.rounded_outward().lower; }

Ring& ring_of(dupin::Piece& piece, End end) {
  return std::visit([=](auto& p) -> Ring& { return end == End::end ? p.end : p.start; }, piece);
}

TEST(Piece, of_any_kind_ends_in_its_rings) {
  for (const dupin::Piece& shape : one_of_each_kind()) {
    for (const End end : {End::start, End::end}) {
      const EndDifference found = end_difference(Piece(shape, 0), end);
      EXPECT_LE(upper(found.offset), 1e-13) << shape.index();
      EXPECT_LE(upper(found.axis_angle), 1e-13) << shape.index();
    }
  }
}

TEST(Piece, of_any_kind_tells_how_far_a_ring_is_off) {
  for (const dupin::Piece& shape : one_of_each_kind()) {
    for (const End end : {End::start, End::end}) {
      dupin::Piece moved = shape, tilted = shape, wide = shape;
      ring_of(moved, end).center += Vec3(0, .03, .04);
      Vec3& normal = ring_of(tilted, end).normal;
      normal = Eigen::AngleAxisd(.25, normal.unitOrthogonal()) * normal;
      ring_of(wide, end).radius += .0625;
      const Wide offset = end_difference(Piece(moved, 0), end).offset,
                 angle = end_difference(Piece(tilted, 0), end).axis_angle,
                 excess = end_difference(Piece(wide, 0), end).offset;
      EXPECT_NEAR(lower(offset), .05, 1e-13) << shape.index();
      EXPECT_NEAR(upper(offset), .05, 1e-13) << shape.index();
      EXPECT_NEAR(lower(angle), .25, 1e-13) << shape.index();
      EXPECT_NEAR(upper(angle), .25, 1e-13) << shape.index();
      EXPECT_NEAR(lower(excess), .0625, 1e-13) << shape.index();
      EXPECT_NEAR(upper(excess), .0625, 1e-13) << shape.index();
    }
  }
}

TEST(Piece, of_any_kind_is_admitted_with_finite_numbers_only) {
  const std::string name = "p";
  for (const dupin::Piece& shape : one_of_each_kind()) {
    EXPECT_NO_THROW(admit(shape, Requirements(name))) << shape.index();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1.0, 0.0, 0x1p301}) {
      for (const End end : {End::start, End::end}) {
        dupin::Piece forged = shape;
        ring_of(forged, end).radius = bad;
        EXPECT_THROW(admit(forged, Requirements(name)), Error) << shape.index() << ' ' << bad;
      }
    }
  }
}

TEST(Piece, of_a_cylinder_has_discs_about_its_axis) {
  const RingedSurface pipe = test::cylinder({0, 0, 0}, {4, 0, 0}, 1);
  const auto discs = discs_of(Piece(pipe, 0), {.25, .75});
  ASSERT_TRUE(discs);
  EXPECT_TRUE(test::holds(discs->radius, 1));
  ASSERT_EQ(discs->centers.size(), 2U);
  EXPECT_TRUE(test::holds(discs->centers.front(), Vec3(1, 0, 0)));
  EXPECT_TRUE(test::holds(discs->centers.back(), Vec3(3, 0, 0)));
}

// The radius rises by 3/4 per length at the start, and falls by 3/8 at the end.
TEST(Piece, of_a_radius_that_bends_has_the_slopes_of_its_ends) {
  RingedSurface bulge = test::cylinder({0, 0, 0}, {4, 0, 0}, 1);
  bulge.radius = BezierRadius{{1, 2.5, 1.75}};
  bulge.start.slope = -.75;
  bulge.end.slope = -.375;
  bulge.end.radius = 1.75;
  for (const End end : {End::start, End::end}) {
    const auto deviation = end_difference(Piece(bulge, 0), end).deviation;
    ASSERT_TRUE(deviation);
    EXPECT_LE(*deviation, 1e-13);
  }
}

TEST(Piece, that_is_rational_has_the_normals_of_its_ends) {
  const RationalRingedSurface surface =
      ringed_blend(along_oblique_cone({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, Vec3(.6, 0, -3), 1.2),
                   along_canal({Vec3(4, 1, 4), Vec3::UnitX(), .8}, 0, 3));
  const MovingRing from = ring_at(surface, 0), to = ring_at(surface, 1);
  const Piece piece(
      RationalRingedTube{
          {from.center, -from.normal, from.radius}, {to.center, to.normal, to.radius}, surface},
      0);
  for (const End end : {End::start, End::end}) {
    EXPECT_LE(upper(end_difference(piece, end).axis_angle), 1e-13);
    EXPECT_LE(upper(end_difference(piece, end).offset), 1e-13);
  }
}

// Bounds are a little more than what differs at the end that differs most.
TEST(Piece, of_a_cone_tells_how_far_it_is_from_a_quadric) {
  const RingedSurface cone = test::cone({0, 0, 0}, {4, 0, 0}, 1, 2);
  const Ring quadric{Vec3(4, 0, 0), Vec3::UnitX(), 2, .25};
  const auto from = [&](const Ring& ring) { return difference_from(ring, Tube(cone)); };
  EXPECT_EQ(from(quadric).offset, 0);
  EXPECT_EQ(from(quadric).deviation, 0);
  Ring other = quadric;
  other.slope = .125;
  EXPECT_NEAR(from(other).offset, .5, 1e-13);
  EXPECT_GE(from(other).deviation, std::atan(.25) - std::atan(.125));
  other.slope = 0;
  EXPECT_TRUE(std::isinf(from(other).offset)) << "as far off as the cone is wide";
  other = quadric;
  other.slope = .25 + 0x1p-20;
  EXPECT_NEAR(from(other).offset, 0x1p-18, 1e-13) << "at the other end";
  EXPECT_NEAR(from(other).deviation, 1.6 * 0x1p-20, 1e-13);
  other = quadric;
  other.radius += 0x1p-10;
  EXPECT_NEAR(from(other).offset, 0x1p-10, 1e-13);
  other = quadric;
  other.center.y() += 0x1p-10;
  EXPECT_NEAR(from(other).offset, 0x1p-10, 1e-13);
  EXPECT_NEAR(from(other).deviation, 1.6 * 2 * 0x1p-10, 1e-5);
  other = quadric;
  other.normal = Vec3(std::cos(.01), std::sin(.01), 0);
  EXPECT_NEAR(from(other).offset, 4 * std::sin(.01), .01) << "where it begins";
  EXPECT_GE(from(other).offset, 4 * std::sin(.01));
  EXPECT_GE(from(other).deviation, .01);
  other.normal = -Vec3::UnitX();
  other.slope = -.25;
  EXPECT_TRUE(std::isinf(from(other).offset)) << "it looks back";
  other = quadric;
  other.center.y() += 1.001;
  EXPECT_TRUE(std::isinf(from(other).deviation)) << "further off than the cone is wide";
  EXPECT_TRUE(std::isinf(difference_from(quadric, Tube(test::elbow(4, 1.5, 1))).offset));
  RingedSurface bulge = cone;
  bulge.radius = BezierRadius{{1, 3, 2}};
  EXPECT_TRUE(std::isinf(difference_from(quadric, Tube(bulge)).offset))
      << "its ends are the cone's";
}

// By the formula in docs/certificate_format.md, with the radius that is largest on either side.
TEST(Piece, of_a_cone_that_leans_is_further_from_a_quadric_the_wider_it_is) {
  const double lean = .1, k = std::sin(lean) * (std::sin(lean) + .25);
  const double off = 1 - std::cos(lean) + 4 * std::sin(lean);  // where it begins
  const Vec3 axis(std::cos(lean), std::sin(lean), 0);
  const RingedSurface grows = test::cone({0, 0, 0}, {4, 0, 0}, 1, 2),
                      falls = test::cone({0, 0, 0}, {4, 0, 0}, 3, 2);
  EXPECT_NEAR(difference_from({Vec3(4, 0, 0), axis, 2, .25}, Tube(grows)).offset,
              (off + 2 * k) / (1 - k), 1e-13);
  EXPECT_NEAR(difference_from({Vec3(4, 0, 0), axis, 2, -.25}, Tube(falls)).offset,
              (off + 3 * k) / (1 - k), 1e-13);
}

PeArc bent_arc() {
  return PeArc::from(test::sphere(4, 0, 0, .7), test::direction(Vec3(.1, 1, .2), .2),
                     test::sphere(.5, 5, .4, 1.6));
}

TEST(Piece, of_a_cyclide_has_discs_within_the_spread_of_their_normals) {
  const PeArc arc = bent_arc();
  for (const double from : {0., .375, .75}) {
    const auto discs = discs_of(Piece(test::cyclide_piece(arc), 0), {from, from + .25});
    ASSERT_TRUE(discs);
    ASSERT_EQ(discs->tangents.size(), 1U);
    const Vec3 middle = circle_at(arc, from + .125).normal;
    EXPECT_TRUE(test::holds(discs->tangents.front(), middle, 1e-13));
    double most = 0;
    for (int i = 0; i <= 16; ++i) {
      most = std::max(most, circle_at(arc, from + i / 64.).normal.cross(middle).norm());
    }
    EXPECT_LE(std::asin(most), discs->spread);
  }
}

TEST(Piece, has_no_discs_where_only_its_middle_is_known) {
  const PeArc half_turn = PeArc::from(test::sphere(4, 0, 0, .7), test::direction(Vec3::UnitY(), 0),
                                      test::sphere(-4, .5, 0, .8));
  const Piece piece(test::cyclide_piece(half_turn), 0);
  ASSERT_TRUE(piece.motion(.5, .5));
  ASSERT_FALSE(piece.motion(0, 1));
  EXPECT_FALSE(discs_of(piece, {0, 1}));
}

}  // namespace
}  // namespace dupin::verification
