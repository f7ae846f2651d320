#include <gtest/gtest.h>

#include "support/cyclide_cases.h"
#include "surfaces/cyclide_discs.h"

// That they hold the piece's circles is tested with the other moving discs.
namespace dupin::surfaces {
namespace {

// Balls that grow along a line: circles across it, all the way.
TEST(CyclideDiscs, of_a_straight_piece_do_not_turn) {
  const Vec3 along = Vec3(1, 2, -.3).normalized();
  const CyclidePiece piece = cyclide_piece(
      PeArc::from(test::sphere(0, 0, 0, 3), test::direction(along, 0), {5 * along, 5.5}));
  const auto disc = CyclideDiscs(piece).over({.5, .515625});
  ASSERT_TRUE(disc);
  const DiscPace found = pace(*disc, .015625);
  EXPECT_LT(found.turning, 1e-12);
  EXPECT_GT(found.advance, .1);
}

// An arm that flares towards its hub; the inner skin, too.
TEST(CyclideDiscs, of_a_straight_piece_advance_which_few_looks_show) {
  const Vec3 along = Vec3(1, 2, -.3).normalized();
  const CyclideDiscs discs(cyclide_piece(
      PeArc::from(test::sphere(0, 0, 0, 2), test::direction(along, 0), {5.4 * along, 5.53})));
  for (const double wall : {0., .5}) {
    for (int i = 0; i < 4; ++i) {
      const auto disc = discs.over({i / 4., (i + 1) / 4.}, wall);
      ASSERT_TRUE(disc);
      EXPECT_GT(numbers::dot(disc->velocity, disc->normal).lower, 0) << wall << " " << i;
    }
  }
}

}  // namespace
}  // namespace dupin::surfaces
