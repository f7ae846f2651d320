#include <gtest/gtest.h>

#include "blends/certification/disc_samples.h"
#include "certification/swept_disc_overlap.h"

namespace dupin::certification {
namespace {

using test::cylinder;
using test::elbow;
using test::is_inside;

TEST(SweptDiscOverlap, is_a_point_inside_discs_of_both_parts) {
  const Chain pipe = cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1);
  const std::pair<const char*, Chain> crossing[] = {
      {"across", cylinder(Vec3(2, -5, 0), Vec3(2, 5, 0), 0.5)},
      {"askew", cylinder(Vec3(0, -5, 1.25), Vec3(1, 5, 1.25), 0.5)},
      {"into it", cylinder(Vec3(1, 0, 9), Vec3(1, 0, 0.75), 0.25)},
      {"along", cylinder(Vec3(4, 0, 0), Vec3(14, 0, 0), 1)},
      {"bent", elbow(3, 3, 0.5)},
      {"of pieces", test::loop(0.5)},
  };
  for (const auto& [about, other] : crossing) {
    SCOPED_TRACE(about);
    const auto found = overlap(SweptDiscs(pipe), SweptDiscs(other));
    ASSERT_TRUE(found);
    EXPECT_TRUE(is_inside(pipe, found->first, found->point));
    EXPECT_TRUE(is_inside(other, found->second, found->point));
    const auto swapped = overlap(SweptDiscs(other), SweptDiscs(pipe));
    ASSERT_TRUE(swapped);
    EXPECT_TRUE(is_inside(other, swapped->first, swapped->point));
    EXPECT_TRUE(is_inside(pipe, swapped->second, swapped->point));
  }
}

TEST(SweptDiscOverlap, of_parts_that_are_apart_is_not_found) {
  const SweptDiscs pipe(cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1));
  EXPECT_FALSE(overlap(pipe, SweptDiscs(cylinder(Vec3(0, -5, 2.01), Vec3(0, 5, 2.01), 1))));
  EXPECT_FALSE(overlap(pipe, SweptDiscs(cylinder(Vec3(5.01, 0, 0), Vec3(9, 0, 0), 1))));
  EXPECT_FALSE(overlap(pipe, SweptDiscs(cylinder(Vec3(5, 0, 0), Vec3(9, 0, 0), 1))))
      << "a common disc is inside of neither";
  EXPECT_FALSE(overlap(pipe, SweptDiscs(Sphere{Vec3(0, 0, 3.01), 2})));
}

TEST(SweptDiscOverlap, of_a_ball_is_a_point_of_the_ball) {
  const Chain pipe = cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1);
  const Sphere ball{Vec3(3, 0, 2.5), 2};
  const auto found = overlap(SweptDiscs(pipe), SweptDiscs(ball));
  ASSERT_TRUE(found);
  EXPECT_TRUE(is_inside(pipe, found->first, found->point));
  EXPECT_LT((found->point - ball.center).norm(), ball.radius);
}

TEST(SweptDiscOverlap, is_not_claimed_of_parts_that_are_more_or_less_than_their_discs) {
  Chain hollow = cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1);
  hollow.wall = 0.125;
  const SweptDiscs skin(hollow), rod(cylinder(Vec3(0, -5, 0), Vec3(0, 5, 0), 0.5));
  EXPECT_FALSE(overlap(skin, rod));
  EXPECT_FALSE(overlap(rod, skin));
  EXPECT_FALSE(contact(skin, rod));
  Chain hollow_loop = test::loop(6);
  hollow_loop.wall = 0.125;
  EXPECT_FALSE(self_overlap(SweptDiscs(hollow_loop)));
}

TEST(SweptDiscOverlap, of_a_part_with_itself_is_between_two_places) {
  const Chain crossing = test::loop(6);
  const auto found = self_overlap(SweptDiscs(crossing));
  ASSERT_TRUE(found);
  EXPECT_TRUE(is_inside(crossing, found->first, found->point));
  EXPECT_TRUE(is_inside(crossing, found->second, found->point));
  EXPECT_GT(std::abs(found->first.from - found->second.from), 1) << "not the same place";
  const Chain straight(std::vector{cylinder(Vec3::Zero(), Vec3(4, 0, 0), 1),
                                   cylinder(Vec3(4, 0, 0), Vec3(8, 0, 0), 1)});
  EXPECT_FALSE(self_overlap(SweptDiscs(straight))) << "a disc of two pieces is one disc";
}

// Only pieces near a point are looked at: the one that it is in has to be among them.
TEST(SweptDiscOverlap, of_a_long_chain_is_found_wherever_it_is) {
  std::vector<RingedSurface> pieces;
  for (int i = 0; i < 60; ++i) {
    pieces.push_back(cylinder(Vec3(2 * i, 0, 0), Vec3(2 * i + 2, 0, 0), 0.25));
  }
  EXPECT_FALSE(self_overlap(SweptDiscs(Chain(pieces))));
  for (const double x : {0.5, 31.0, 60.0, 119.5}) {
    std::vector<RingedSurface> crossed = pieces;
    crossed.push_back(cylinder(Vec3(x, -5, 0), Vec3(x, 5, 0), 0.25));
    const Chain chain(crossed);
    const auto found = self_overlap(SweptDiscs(chain));
    ASSERT_TRUE(found) << x;
    EXPECT_TRUE(is_inside(chain, found->first, found->point));
    EXPECT_TRUE(is_inside(chain, found->second, found->point));
    EXPECT_NEAR(found->point.x(), x, 0.25);
  }
}

TEST(SweptDiscOverlap, is_looked_for_with_half_of_the_work_that_is_left) {
  std::vector<RingedSurface> pieces;
  for (int i = 0; i < 60; ++i) {
    pieces.push_back(cylinder(Vec3(2 * i, 0, 0), Vec3(2 * i + 2, 0, 0), 0.25));
  }
  SearchWork work(1 << 15);
  EXPECT_FALSE(self_overlap(SweptDiscs(Chain(pieces), &work)));
  EXPECT_GT(work.left(), 1u << 13);
  EXPECT_LT(work.left(), 1u << 14);
}

TEST(SweptDiscOverlap, contacts_are_centres_of_ends_in_ends) {
  const Chain plate = cylinder(Vec3(0, 0, -1), Vec3(0, 0, 0), 5);
  const auto post = [](const Vec3& at, double radius) {
    return Chain(cylinder(at, at + Vec3(0, 0, 3), radius));
  };
  const auto touching = [&](const Chain& a, const Chain& b) {
    return contact(SweptDiscs(a), SweptDiscs(b));
  };
  // Either centre may lie in the other ring.
  for (const double x : {0.0, 1.0, 5.0}) {
    const auto found = touching(plate, post(Vec3(x, 0, 0), 1));
    ASSERT_TRUE(found) << x;
    EXPECT_EQ(found->first, (ParameterInterval{1, 1}));
    EXPECT_EQ(found->second, (ParameterInterval{0, 0}));
    EXPECT_EQ(found->point.z(), 0);
  }
  const auto wide = touching(post(Vec3(5.5, 0, 0), 6), plate);
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->point, Vec3::Zero());
  EXPECT_EQ(wide->first, (ParameterInterval{0, 0}));
  EXPECT_EQ(wide->second, (ParameterInterval{1, 1}));
  EXPECT_FALSE(touching(plate, post(Vec3(5.5, 0, 0), 1))) << "touches, but not in a centre";
  EXPECT_FALSE(touching(plate, post(Vec3(1, 0, 0x1p-60), 1)));
  EXPECT_FALSE(touching(plate, post(Vec3(1, 0, -0x1p-60), 1)));
  // Seams are no ends.
  const Chain two(std::vector{cylinder(Vec3(0, 0, -1), Vec3(0, 0, 0), 5),
                              cylinder(Vec3(0, 0, 0), Vec3(0, 0, 1), 5)});
  EXPECT_FALSE(touching(two, post(Vec3(1, 0, 0), 1)));
  ASSERT_TRUE(touching(two, post(Vec3(1, 0, 1), 1)));
  EXPECT_EQ(touching(two, post(Vec3(1, 0, 1), 1))->first, (ParameterInterval{2, 2}));
  // The plane of an end is known, but not which ellipse a disc is.
  RingedSurface elliptic = cylinder(Vec3(1, 0, 0), Vec3(1, 0, 3), 1);
  elliptic.start.ellipse = Ellipse{Vec3::UnitX(), 0.5};
  EXPECT_FALSE(touching(plate, Chain(elliptic)));
}

// Their boxes hold most points of each other.
TEST(SweptDiscOverlap, of_long_pipes_that_all_but_touch_looks_at_few_discs) {
  const auto row = [](double y) {
    std::vector<RingedSurface> pieces;
    for (double x = 0; x < 20; ++x) {
      pieces.push_back(cylinder(Vec3(x, y, x), Vec3(x + 1, y, x + 1), 1));
    }
    return Chain(pieces);
  };
  SearchWork work(1 << 20);
  EXPECT_FALSE(overlap(SweptDiscs(row(0), &work), SweptDiscs(row(2.01), &work)));
  EXPECT_LT(work.spent(), 50'000U);
}

}  // namespace
}  // namespace dupin::certification
