#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "blends/certification/disc_samples.h"
#include "certification/swept_discs.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/elliptic_tube.h"
#include "support/cyclide_cases.h"

namespace dupin::certification {
namespace {

using test::cone;
using test::cylinder;
using test::elbow;

constexpr double kQuarter = std::numbers::pi / 2;

// A cone up to a bend, the bend, and a pipe from it.
Chain example() {
  return Chain(std::vector{cone(Vec3(3, -4, 0), Vec3(3, 0, 0), 2, 1), elbow(3, kQuarter, 1),
                           cylinder(Vec3(0, 3, 0), Vec3(-5, 3, 0), 1)});
}

TEST(SweptDiscs, have_a_stretch_for_each_piece) {
  const SweptDiscs chain(example()), ball(Sphere{Vec3(1, 2, 3), 2});
  EXPECT_EQ(chain.length(), 3);
  EXPECT_EQ(chain.stretches(), (std::vector<ParameterInterval>{{0, 1}, {1, 2}, {2, 3}}));
  ASSERT_EQ(chain.end_rings().size(), 2U);
  EXPECT_EQ(chain.end_rings()[0].center, Vec3(3, -4, 0));
  EXPECT_EQ(chain.end_rings()[1].center, Vec3(-5, 3, 0));
  EXPECT_FALSE(chain.closed());
  EXPECT_EQ(ball.length(), 1);
  EXPECT_EQ(ball.stretches(), (std::vector<ParameterInterval>{{0, 1}}));
  EXPECT_TRUE(ball.end_rings().empty());
  const SweptDiscs ring(Chain(std::vector{elbow(3, 4 * kQuarter, 1)}, true));
  EXPECT_TRUE(ring.closed());
  EXPECT_TRUE(ring.end_rings().empty());
}

TEST(SweptDiscs, are_all_of_a_part_or_not) {
  EXPECT_TRUE(SweptDiscs(example()).full());
  EXPECT_TRUE(SweptDiscs(Sphere{Vec3::Zero(), 1}).full());
  Chain hollow = example();
  hollow.wall = 0.25;
  EXPECT_FALSE(SweptDiscs(hollow).full());
  const auto ring = [](double z, double normal) {
    return Ring{Vec3(0, 0, z), Vec3(0, 0, normal), 1, 0, Ellipse{Vec3::UnitX(), 0.5}};
  };
  const EllipticTube duct =
      elliptic_tube(ring(0, -1), ring(4, 1), LineSpine{Vec3::Zero(), Vec3(0, 0, 4)},
                    ConstantRadius{1}, ConstantRadius{0.5});
  EXPECT_FALSE(SweptDiscs(Chain(duct)).full());
  const std::vector<PeVector> spheres = {
      {Vec3(0, 0, 0), 1}, {Vec3(2, 1, 0), .8}, {Vec3(4, 1, 0), 1}};
  const SweptDiscs knees(kneecap_chain(spheres));
  EXPECT_FALSE(knees.full());
  EXPECT_EQ(knees.length(), 1);
  const SweptDiscs none((Chain()));
  EXPECT_FALSE(none.full());
  EXPECT_EQ(none.length(), 0);
  std::vector<DiscPace> way;
  EXPECT_FALSE(none.append_way({0, 0}, way));
}

// A right angle of pipes of radius 1: the ball at the joint is on the outer side of both.
TEST(SweptDiscs, at_a_kneecap_come_with_its_ball) {
  const Chain chain = kneecap_chain(test::corner_spheres(std::numbers::pi / 2));
  const SweptDiscs knees(chain), discs = knees.discs_only();
  EXPECT_TRUE(knees.has_kneecaps());
  const Vec3 out = Vec3(1, -1, 0).normalized();
  for (const ParameterInterval& t : {ParameterInterval{0, 1}, {.75, 1}, {1, 1.25}, {1, 2}}) {
    EXPECT_TRUE(knees.touches_knee(t));
    EXPECT_FALSE(discs.touches_knee(t));
    EXPECT_GE(surfaces::support(knees.over(t), out), 1);
    EXPECT_LT(surfaces::support(knees.over(t), out), 1 + 1e-9);
    EXPECT_LT(surfaces::support(discs.over(t), out), .75);
  }
  for (const ParameterInterval& t : {ParameterInterval{0, .75}, {1.25, 2}, {0, 0}, {2, 2}}) {
    EXPECT_FALSE(knees.touches_knee(t));
    EXPECT_EQ(surfaces::support(knees.over(t), out), surfaces::support(discs.over(t), out));
  }
}

// Half-spaces around a hull hold all discs of its stretch, and not much more if that is short.
TEST(SweptDiscs, hulls_hold_the_discs_of_their_stretch) {
  const Chain chain = example();
  const SweptDiscs sweep(chain);
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const ParameterInterval& t :
       {ParameterInterval{0, 1}, ParameterInterval{0.25, 0.5}, ParameterInterval{1, 2},
        ParameterInterval{1.5, 1.5625}, ParameterInterval{2, 3}, ParameterInterval{2.75, 3},
        ParameterInterval{3, 3}}) {
    const DiscHull hull = sweep.over(t);
    for (int i = 0; i < 20; ++i) {
      const Vec3 direction = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
      double farthest = -std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 16; ++k) {
        for (const Vec3& point : test::disc_at(chain, std::lerp(t.from, t.to, k / 16.0)).points()) {
          farthest = std::max(farthest, point.dot(direction));
        }
      }
      EXPECT_GE(support(hull, direction), farthest - 1e-12);
      EXPECT_LE(support(hull, direction), farthest + 0.05 + 3 * size(t)) << t.from;
    }
  }
}

TEST(SweptDiscs, of_a_ball_are_the_ball) {
  const DiscHull hull = SweptDiscs(Sphere{Vec3(1, 2, 3), 2}).over({0, 1});
  EXPECT_TRUE(hull.tangents.empty()) << "any normal";
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -0.6, 0.8)}) {
    EXPECT_NEAR(support(hull, direction), Vec3(1, 2, 3).dot(direction) + 2, 1e-12);
  }
}

TEST(SweptDiscs, turn_little_by_at_most_a_right_angle_within_a_piece) {
  const SweptDiscs sweep(Chain(std::vector{test::elbow_of_bezier(3, 2 * kQuarter, 1),
                                           test::elbow_of_bezier(3, kQuarter, 1)}));
  const struct {
    ParameterInterval t;
    bool expected;
  } rows[] = {
      {{0, 0.4375}, true}, {{0.5, 0.9375}, true}, {{0, 0.5625}, false},
      {{0, 1}, false},     {{1, 1.9375}, true},   {{0.9375, 1.0625}, false},  // a seam
  };
  for (const auto& row : rows) {
    EXPECT_EQ(sweep.turns_little(row.t, 0.5), row.expected) << row.t.from << " " << row.t.to;
  }
}

TEST(SweptDiscs, stay_on_one_side_within_a_piece) {
  const SweptDiscs sweep(Chain(std::vector{elbow(3, 3 * kQuarter, 1), elbow(3, kQuarter, 1)}));
  EXPECT_TRUE(sweep.stays_on_one_side({0, .625}));
  EXPECT_FALSE(sweep.stays_on_one_side({0, .75}));
  EXPECT_TRUE(sweep.stays_on_one_side({1, 2}));
  EXPECT_FALSE(sweep.stays_on_one_side({.9375, 1.0625})) << "a seam";
  EXPECT_FALSE(SweptDiscs(Sphere{Vec3::Zero(), 1}).stays_on_one_side({0, 1}));
}

// The pace of an arc of bend radius 3 per unit of its parameter: it advances by 3 times its angle
// and turns by the angle.
TEST(SweptDiscs, ways_lead_over_seams) {
  const SweptDiscs sweep(example());
  std::vector<DiscPace> way;
  ASSERT_TRUE(sweep.append_way({0.5, 2.25}, way));
  double width = 0, turned = 0, sideways = 0;
  for (const DiscPace& pace : way) {
    width += pace.width;
    turned += pace.width * pace.turning;
    sideways = std::max(sideways, pace.sideways);
    EXPECT_GT(pace.advance, 0);
    EXPECT_LE(pace.turning / pace.advance, 1.0 / 3 + 1e-9) << "the curvature";
  }
  EXPECT_NEAR(width, 1.75, 1e-12);
  EXPECT_GE(turned, kQuarter);
  EXPECT_LT(turned, 1.05 * kQuarter);
  EXPECT_LT(sideways, 0.75);
  const std::size_t cells = way.size();
  ASSERT_TRUE(sweep.append_way({0, 0.5}, way)) << "appended";
  EXPECT_GT(way.size(), cells);
  // Where the spine stops there is no pace.
  RingedSurface back = cylinder(Vec3::Zero(), Vec3(4, 0, 0), 1);
  back.spine = BezierSpine{{Vec3::Zero(), Vec3(9, 0, 0), Vec3(4, 0, 0)}};
  EXPECT_FALSE(SweptDiscs(Chain(back)).append_way({0, 1}, way));
}

TEST(SweptDiscs, count_what_they_are_asked) {
  SearchWork work(10);
  const SweptDiscs pipe(test::cylinder(Vec3::Zero(), Vec3(5, 0, 0), 1), &work);
  EXPECT_FALSE(pipe.is_out_of_work());
  (void)pipe.over({0, 1});
  EXPECT_FALSE(pipe.is_out_of_work());
  std::vector<DiscPace> way;
  EXPECT_TRUE(pipe.append_way({0, 1}, way));
  EXPECT_TRUE(pipe.is_out_of_work());
  (void)pipe.over({0, 1});
  EXPECT_TRUE(pipe.is_out_of_work()) << "it stays so";
  EXPECT_FALSE(SweptDiscs(test::cylinder(Vec3::Zero(), Vec3(5, 0, 0), 1)).is_out_of_work());
}

}  // namespace
}  // namespace dupin::certification
