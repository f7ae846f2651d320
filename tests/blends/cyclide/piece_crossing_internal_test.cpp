#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cyclide/piece_crossing.h"
#include "support/cyclide_cases.h"

namespace dupin::cyclide {
namespace {

PeArc straight(const Vec3& from, const Vec3& to, double radius) {
  return PeArc::from({from, radius}, test::direction(to - from, 0), {to, radius});
}

Ring ring(const Vec3& center, const Vec3& travel, double radius) {
  return {center, travel.normalized(), radius};
}

// By discs, whose places are not to be those where the other piece begins.
TEST(PiecesCross, where_they_pass_through_each_other) {
  const Ring start = ring({-5, 0, 0}, {1, 0, 0}, 1), end = ring({20, 20, 0}, {0, 1, 0}, 1);
  const PeArc along = straight({-5, 0, 0}, {5, 0, 0}, 1);
  for (const double height : {0., 1., 1.5}) {
    EXPECT_TRUE(
        pieces_cross({along, straight({.17, -5.1, height}, {.17, 5.2, height}, 1)}, start, end));
  }
  for (const double height : {2.1, 3.}) {
    EXPECT_FALSE(
        pieces_cross({along, straight({.17, -5.1, height}, {.17, 5.2, height}, 1)}, start, end));
  }
}

TEST(PiecesCross, not_where_one_goes_on_from_the_other) {
  // Two quarters of a torus.
  const PeArc first = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                  test::sphere(0, 4, 0, 1));
  const PeArc second = PeArc::from(first.end(), first.end_tangent(), test::sphere(-4, 0, 0, 1));
  const Ring start = ring({4, 0, 0}, {0, 1, 0}, 1), end = ring({-4, 0, 0}, {0, -1, 0}, 1);
  EXPECT_FALSE(pieces_cross({first, second}, start, end));
  EXPECT_FALSE(pieces_cross({first}, start, circle_at(first, 1)));
}

TEST(PiecesCross, where_a_piece_meets_the_pipes_before_and_after) {
  // The pipe before the start comes from y < 0, a diameter far.
  const Ring start = ring({0, 0, 0}, {0, 1, 0}, 1), end = ring({30, 0, 0}, {1, 0, 0}, 1);
  const PeArc beside = straight({-6.1, -1.1, .2}, {6.2, -1.1, .2}, .5);
  EXPECT_TRUE(pieces_cross({beside}, start, end));
  EXPECT_FALSE(pieces_cross({straight({-6, -4, 0}, {6, -4, 0}, .5)}, start, end));
  const Ring after = ring({0, 0, 0}, {0, -1, 0}, 1), far = ring({0, 50, 0}, {0, 1, 0}, 1);
  EXPECT_TRUE(pieces_cross({beside}, far, after));
  // That the pipes cross each other is not the pieces' fault.
  EXPECT_FALSE(pieces_cross({}, start, after));
}

TEST(PiecesCross, lets_pass_what_overlaps_by_little) {
  const Ring start = ring({-5, 0, 0}, {1, 0, 0}, 1), end = ring({20, 20, 0}, {0, 1, 0}, 1);
  const PeArc along = straight({-5, 0, 0}, {5, 0, 0}, 1);
  EXPECT_FALSE(pieces_cross({along, straight({0, -5, 1.99}, {0, 5, 1.99}, 1)}, start, end));
}

}  // namespace
}  // namespace dupin::cyclide
