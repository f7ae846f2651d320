#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/rational_ringed_surface.h"
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

}  // namespace
}  // namespace dupin::verification
