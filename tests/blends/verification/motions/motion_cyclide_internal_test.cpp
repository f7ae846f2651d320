#include <cmath>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/cyclide_cases.h"
#include "verification/motions/motion.h"

namespace dupin::verification {
namespace {

using test::holds;

TEST(MotionCyclide, of_cyclide_pieces_holds_their_circles) {
  test::RandomArcs arcs;
  for (int i = 0; i < 5; ++i) {
    const PeArc arc = arcs.next();
    const CyclidePiece piece = test::cyclide_piece(arc);
    for (const double t : {.25, .5, .75}) {
      const auto found = motion(piece, 0)(t, t);
      ASSERT_TRUE(found);
      const Ring disc = circle_at(arc, t);
      EXPECT_TRUE(holds(part(found->center, 0), disc.center, 1e-10));
      EXPECT_TRUE(holds(part(found->normal, 0), disc.normal, 1e-10));
      EXPECT_TRUE(holds(found->radius[0], disc.radius, 1e-10));
      // `pace` is the rate of the tangential length.
      const double h = 1e-5;
      EXPECT_TRUE(holds(
          found->pace[0],
          std::sqrt(squared_tangential_distance(sphere_at(arc, t + h), sphere_at(arc, t - h))) /
              (2 * h),
          1e-3));
    }
  }
}

// Spheres that grow faster than they move at first, and have no circle then.
TEST(MotionCyclide, is_none_where_spheres_may_hold_each_other) {
  const CyclidePiece piece{
      {}, {}, test::sphere(0, 0, 0, 1), {Vec3(.5, 0, 0), 1}, test::sphere(4, 0, 0, 1), 4};
  const Motion circles = motion(piece, 0);
  double without = 0, with = .5;
  ASSERT_FALSE(circles(without, without));
  ASSERT_TRUE(circles(with, with));
  while (with - without > 1e-9) {
    const double middle = (without + with) / 2;
    (circles(middle, middle) ? with : without) = middle;
  }
  EXPECT_FALSE(circles(without - 1e-6, with + 1e-6));
  EXPECT_TRUE(circles(with + 1e-6, with + 2e-6));
}

// Balls that grow along a line: circles across it, all the way.
TEST(MotionCyclide, of_a_straight_piece_of_a_cyclide_does_not_turn) {
  const Vec3 along = Vec3(1, 2, -.3).normalized();
  const PeArc arc =
      PeArc::from(test::sphere(0, 0, 0, 3), test::direction(along, 0), {5 * along, 5.5});
  const auto disc = motion(test::cyclide_piece(arc), 0)(.5, .515625);
  ASSERT_TRUE(disc);
  EXPECT_LT(numbers::norm(part(disc->normal, 1)).upper, 1e-12);
  EXPECT_LT(numbers::norm(part(disc->normal, 2)).upper, 1e-10);
  EXPECT_GT(numbers::dot(part(disc->center, 1), part(disc->normal, 0)).lower, .1);
}

}  // namespace
}  // namespace dupin::verification
