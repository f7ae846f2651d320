#include <gtest/gtest.h>

#include "blends/certification/disc_samples.h"
#include "certification/common_points.h"
#include "certification/swept_disc_overlap.h"
#include "certification/swept_disc_pairs.h"

namespace dupin::certification {
namespace {

using test::cylinder;
using test::is_inside;

// Balls that dip into a pipe's side, its end and its rim, by much and by little.
TEST(CommonPoints, are_inside_of_balls_and_pipes) {
  const Chain pipe = cylinder(Vec3(-50, 0, 0), Vec3(50, 0, 0), 10);
  for (const Sphere& ball :
       {Sphere{Vec3(0, 0, 12), 3}, Sphere{Vec3(0, 0, 12.9), 3}, Sphere{Vec3(7, 3, 13), 4},
        Sphere{Vec3(0, 13, 0), 3.2}, Sphere{Vec3(57.5, 0, 0), 8}, Sphere{Vec3(55, 12, 0), 6}}) {
    const auto points = common_points(SweptDiscs(pipe), SweptDiscs(ball));
    ASSERT_FALSE(points.empty()) << ball.center.transpose();
    for (const Vec3& point : points) {
      EXPECT_LT((point - ball.center).norm(), ball.radius);
      EXPECT_LT(std::hypot(point.y(), point.z()), 10);
      EXPECT_LT(std::abs(point.x()), 50);
    }
    const ClearanceClaim claim = prove_clearance(SweptDiscs(pipe), SweptDiscs(ball), 1 << 10);
    ASSERT_TRUE(claim.overlap) << ball.center.transpose();
    EXPECT_TRUE(is_inside(pipe, claim.overlap->first, claim.overlap->point));
  }
}

// A pipe's end in a ball, as where an arm of a junction is short: by a ten thousandth of the
// length.
TEST(CommonPoints, are_inside_of_ends_that_dip_into_a_ball_by_little) {
  const Chain pipe = cylinder(Vec3(5.5334, 0, 0), Vec3(34.5, 0, 0), 2);
  for (const double depth : {1e-3, 1e-6}) {
    const Sphere ball{Vec3::Zero(), 5.5334 + depth};
    const auto found = overlap(SweptDiscs(ball), SweptDiscs(pipe));
    ASSERT_TRUE(found) << depth;
    EXPECT_LT(found->point.norm(), ball.radius);
    EXPECT_GT(found->point.x(), 5.5334);
  }
  EXPECT_FALSE(overlap(SweptDiscs(Sphere{Vec3::Zero(), 5.5333}), SweptDiscs(pipe)));
}

// Pipes so long that no samples of theirs meet.
TEST(CommonPoints, are_inside_of_long_pipes) {
  const Chain one = cylinder(Vec3(-300, 0, 0), Vec3(500, 0, 0), 2);
  for (const double height : {0.0, 2.5, 3.9, 3.99}) {
    const Chain other = cylinder(Vec3(13, -317, height), Vec3(13, 400, height), 2);
    const auto found = overlap(SweptDiscs(one), SweptDiscs(other));
    ASSERT_TRUE(found) << height;
    EXPECT_TRUE(is_inside(one, found->first, found->point));
    EXPECT_TRUE(is_inside(other, found->second, found->point));
  }
}

TEST(CommonPoints, are_none_of_what_is_apart) {
  const Chain pipe = cylinder(Vec3(-50, 0, 0), Vec3(50, 0, 0), 10);
  EXPECT_TRUE(common_points(SweptDiscs(pipe), SweptDiscs(Sphere{Vec3(0, 0, 13.01), 3})).empty());
  EXPECT_TRUE(common_points(SweptDiscs(pipe), SweptDiscs(Sphere{Vec3(58.01, 0, 0), 8})).empty());
}

}  // namespace
}  // namespace dupin::certification
