#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/tubes.h"
#include "support/paper_surfaces.h"
#include "surfaces/swept_disc_tube.h"

namespace dupin::surfaces {
namespace {

SweptDiscTube tube(const Spine& spine, const RadiusLaw& radius) {
  return SweptDiscTube(RingedSurface{{}, {}, spine, radius});
}

ArcSpine arc(double angle) { return {Vec3(1, 2, 3), Vec3::UnitZ(), Vec3(5, 2, 3), angle}; }

std::vector<Spine> spines() {
  return {LineSpine{Vec3(0, 0, 0), Vec3(3, 4, 1)}, arc(.5), arc(6), test::skew_spine(10, 20),
          BezierSpine{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(3, 3, 1)}, {1, 2, .5, 1}}};
}

double support(const std::vector<numbers::IntervalVec>& all, const Vec3& w) {
  double furthest = -1e300;
  for (const numbers::IntervalVec& v : all) {
    furthest = std::max(furthest, dot(v, numbers::interval_vec(w)).upper);
  }
  return furthest;
}

// Half spaces that contain the controls contain the curve, and the tangents where they pass
// through the origin.
TEST(SweptDiscTube, controls_enclose_the_centres_and_the_tangents) {
  std::mt19937_64 random(14);
  std::normal_distribution<double> normal;
  for (const Spine& spine : spines()) {
    SCOPED_TRACE(spine.index());
    const SweptDiscTube discs = tube(spine, ConstantRadius{1});
    for (const ParameterInterval& t :
         {ParameterInterval{0, 1}, {.25, .5}, {.5, .5 + 0x1p-6}, {1 - 0x1p-4, 1}}) {
      const SweptDiscTube::Part part = discs.curve(t);
      int cones = 0;
      for (int i = 0; i < 200; ++i) {
        const Vec3 w = Vec3(normal(random), normal(random), normal(random)).normalized();
        const double furthest = support(part.centers, w);
        const bool is_behind = support(part.tangents, w) <= 0;
        cones += is_behind ? 1 : 0;
        double reached = -1e300;
        for (int k = 0; k <= 20; ++k) {
          const SpinePoint y = evaluate(spine, std::lerp(t.from, t.to, k / 20.));
          reached = std::max(reached, y.position.dot(w));
          if (is_behind) {
            EXPECT_LE(y.first.dot(w), 1e-12 * y.first.norm());
          }
        }
        EXPECT_LE(reached, furthest + 1e-13);
        // Controls of short stretches are near to the curve.
        if (t.to - t.from < .1) {
          EXPECT_LE(furthest, reached + .1);
        }
      }
      EXPECT_GT(cones, t.to - t.from < .1 ? 50 : -1);
    }
  }
}

TEST(SweptDiscTube, radius_is_that_of_the_law_or_of_the_larger_semi_axis) {
  const std::vector<RadiusLaw> laws{ConstantRadius{2}, LinearRadius{1, 3}, CubicRadius{3, 1},
                                    CyclideRadius{1, 3}, BezierRadius{{1, 3, .5, 2}}};
  for (const RadiusLaw& first : laws) {
    for (const RadiusLaw& second : laws) {
      EllipticTube elliptic;
      elliptic.spine = LineSpine{Vec3(0, 0, 0), Vec3(4, 0, 0)};
      elliptic.first = first;
      elliptic.second = second;
      const SweptDiscTube discs(elliptic);
      for (double from = 0; from < 1; from += .125) {
        const numbers::Interval all = discs.radius({from, from + .125});
        double least = 1e300, most = 0;
        for (int k = 0; k <= 16; ++k) {
          const double t = from + k / 128.;
          const double radius = std::max(evaluate(first, t).value, evaluate(second, t).value);
          least = std::min(least, radius);
          most = std::max(most, radius);
        }
        EXPECT_LE(all.lower, least * (1 + 1e-14));
        EXPECT_GE(all.upper, most * (1 - 1e-14));
        EXPECT_LE(all.upper, most + .2);
        EXPECT_GE(all.lower, least - .2);
      }
    }
  }
}

// On a curve that does not say that it is an arc.
Spine arc_of_bezier(double angle) { return test::elbow_of_bezier(4, angle, 1).spine; }

TEST(SweptDiscTube, turns_little_up_to_a_right_angle_and_where_the_margin_permits) {
  struct Row {
    Spine spine;
    RadiusLaw radius;
    double margin;
    bool little;
  };
  const Row rows[] = {
      {arc_of_bezier(1.57), ConstantRadius{1}, 0, true},
      {arc_of_bezier(1.58), ConstantRadius{1}, 0, false},
      {arc_of_bezier(1.57), LinearRadius{1, 3}, 0, true},  // grows all the way
      {arc_of_bezier(1.57), BezierRadius{{3, 2, 2, 1}}, 0, true},
      {arc_of_bezier(1.57), BezierRadius{{1, 2, 1}}, 0, false},  // grows and falls
      {arc_of_bezier(1.57), BezierRadius{{1, 2, 1}}, .6, true},  // by less than the margin
      {arc_of_bezier(1.57), ConstantRadius{0}, 0, false},
      {test::skew_spine(10, 20), ConstantRadius{1}, 0, false},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(tube(row.spine, row.radius).turns_little({0, 1}, row.margin), row.little)
        << &row - rows;
  }
  EXPECT_TRUE(tube(test::skew_spine(10, 20), ConstantRadius{1}).turns_little({.5, .625}, 0));
  // Of semi-axes, one of which grows while the other falls.
  EllipticTube elliptic;
  elliptic.spine = arc_of_bezier(1);
  elliptic.first = LinearRadius{1, 2};
  elliptic.second = LinearRadius{1, 2};
  EXPECT_TRUE(SweptDiscTube(elliptic).turns_little({0, 1}, 0));
  elliptic.second = LinearRadius{2, 1};
  EXPECT_FALSE(SweptDiscTube(elliptic).turns_little({0, 1}, 0));
}

// About (1, 2, 3), with the radius 4.
TEST(SweptDiscTube, turns_little_on_an_arc_of_a_larger_radius_that_is_no_full_turn) {
  const struct {
    double angle;
    RadiusLaw radius;
    bool little;
  } rows[] = {
      {6.283, ConstantRadius{3.9999}, true},
      {6.284, ConstantRadius{1}, false},
      {3, ConstantRadius{4}, false},
      {3, LinearRadius{1, 3.9}, true},
      {3, LinearRadius{1, 4.1}, false},
      {3, BezierRadius{{1, 3, 1}}, true},
      {3, BezierRadius{{1, -4.1, 1}}, false},
      {3, ConstantRadius{4 * (1 - 0x1p-36)}, true},
      {3, ConstantRadius{4 * (1 - 0x1p-44)}, false}  // a checker may find it too large
  };
  for (const auto& row : rows) {
    EXPECT_EQ(tube(arc(row.angle), row.radius).turns_little({0, 1}, 0), row.little) << &row - rows;
  }
}

TEST(SweptDiscTube, stays_on_one_side_along_lines_and_less_than_half_a_turn) {
  const LineSpine line{Vec3(0, 0, 0), Vec3(3, 4, 1)};
  EXPECT_TRUE(tube(line, LinearRadius{1, 9}).stays_on_one_side({0, 1}));
  EXPECT_FALSE(tube(LineSpine{line.to, line.to}, ConstantRadius{1}).stays_on_one_side({0, 1}));
  EXPECT_FALSE(tube(arc_of_bezier(1), ConstantRadius{1}).stays_on_one_side({0, 1}));
  EXPECT_TRUE(tube(arc(3.14), ConstantRadius{3.999}).stays_on_one_side({0, 1}));
  EXPECT_FALSE(tube(arc(3.14), ConstantRadius{4}).stays_on_one_side({0, 1}));
  EXPECT_FALSE(tube(arc(3.15), ConstantRadius{1}).stays_on_one_side({0, 1}));
  EXPECT_FALSE(tube(arc(6.28), ConstantRadius{1}).stays_on_one_side({0, 1}));
  EXPECT_TRUE(tube(arc(6.28), ConstantRadius{1}).stays_on_one_side({.25, .5}));
  EXPECT_FALSE(tube(arc(std::numbers::pi), ConstantRadius{1}).stays_on_one_side({0, 1}))
      << "but for less than a checker's rounding";
}

TEST(SweptDiscTube, pace_is_the_spines_speed_and_turning) {
  for (const Spine& spine : spines()) {
    const SweptDiscTube discs = tube(spine, LinearRadius{1, 2});
    for (const double from : {0., .5}) {
      const auto pace = discs.pace({from, from + 0x1p-6});
      ASSERT_TRUE(pace.has_value());
      const SpinePoint y = evaluate(spine, from);
      const double speed = y.first.norm(), turning = curvature(y) * speed;
      EXPECT_LE(pace->advance, speed * (1 + 1e-14));
      EXPECT_GE(pace->advance, .8 * speed);
      EXPECT_GE(pace->turning, turning * (1 - 1e-14));
      EXPECT_LE(pace->turning, 1.3 * turning + .1);
      EXPECT_EQ(pace->sideways, 0);
      EXPECT_NEAR(pace->width, 0x1p-6, 1e-17);
      EXPECT_NEAR(pace->radius.lower, 1 + from, 1e-14);
    }
  }
  const BezierSpine stops{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}};
  EXPECT_FALSE(tube(stops, ConstantRadius{1}).pace({.25, .75}).has_value());
  EXPECT_TRUE(tube(stops, ConstantRadius{1}).pace({0, .25}).has_value());
}

}  // namespace
}  // namespace dupin::surfaces
