#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"
#include "verification/motions/tube.h"

namespace dupin::verification {
namespace {

using std::numbers::pi;

std::vector<RingedSurface> surfaces() {
  const BezierSpine quartic{
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(3, 2, 1), Vec3(3, 3, 3)}};
  BezierSpine rational = quartic;
  rational.weights = {1, 2, .5, 1.5, 1};
  return {test::cylinder({0, 0, 0}, {1, 2, 3}, .5),
          test::cone({0, 0, 0}, {3, 0, 0}, .5, 1),
          test::elbow(3, 2, 1),
          test::figure6(),
          test::figure6(CyclideRadius{1, 2}),
          {{}, {}, quartic, BezierRadius{{.5, .7, .3, .4}}},
          {{}, {}, rational, CubicRadius{.5, .25}}};
}

TEST(Tube, discs_reach_no_further_than_the_bound_says) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> gauss;
  for (const RingedSurface& surface : surfaces()) {
    const Tube tube(surface);
    const FrameField frames(surface.spine, Vec3(.3, .5, .9));
    for (const auto& [from, to] : {std::pair(0., 1.), {.25, .5}, {.5, .5625}}) {
      const Discs discs = tube.discs(from, to);
      for (int i = 0; i < 12; ++i) {
        const Vec3 w = Vec3(gauss(random), gauss(random), gauss(random)).normalized();
        double reached = -1e9;
        for (int j = 0; j <= 8; ++j) {
          for (int k = 0; k < 32; ++k) {
            const double t = from + j * (to - from) / 8;
            reached =
                std::max(reached, w.dot(evaluate(surface, frames, t, 2 * pi * k / 32).position));
          }
        }
        const double bound = furthest(discs, numbers::interval_vec(w));
        EXPECT_GE(bound, reached - 1e-12);
        // Hulls of control points and whole radii are not much larger on short stretches.
        if (to - from < .1) {
          EXPECT_LE(bound, reached + 1);
        }
      }
    }
  }
}

TEST(Tube, disc_at_one_place_is_the_disc) {
  for (const RingedSurface& surface : surfaces()) {
    const Tube tube(surface);
    for (const double t : {0., .375, 1.}) {
      const SpinePoint y = evaluate(surface.spine, t);
      const Discs disc = tube.discs(t, t);
      ASSERT_EQ(disc.centers.size(), 1u);
      EXPECT_LT((middle(disc.centers[0]) - y.position).norm(), 1e-12);
      EXPECT_LT((middle(disc.tangents.front()).normalized() - y.first.normalized()).norm(), 1e-12);
      EXPECT_TRUE(test::holds(disc.radius, evaluate(surface.radius, t).value, 1e-14));
      // Along the normal, and across it.
      const Vec3 along = y.first.normalized(), across = along.unitOrthogonal();
      EXPECT_NEAR(furthest(disc, numbers::interval_vec(across)),
                  across.dot(y.position) + evaluate(surface.radius, t).value, 1e-12);
      EXPECT_NEAR(furthest(disc, numbers::interval_vec(along)), along.dot(y.position), 1e-12);
    }
  }
}

TEST(Tube, radius_range_holds_the_radii_of_the_stretch) {
  for (const RingedSurface& surface : surfaces()) {
    const Tube tube(surface);
    for (const double from : {0., .5, .875}) {
      const Interval range = tube.radius_range(from, from + .125);
      for (int i = 0; i <= 8; ++i) {
        EXPECT_TRUE(test::holds(range, evaluate(surface.radius, from + i / 64.).value, 1e-14));
      }
      EXPECT_LT(range.upper - range.lower, .25);
    }
    EXPECT_EQ(tube.radius(0, 1).empty(), std::holds_alternative<CyclideRadius>(surface.radius));
  }
}

TEST(Tube, stretch_is_the_spine_in_the_parameter_of_the_stretch) {
  for (const RingedSurface& surface : surfaces()) {
    const Tube tube(surface);
    if (tube.arc() != nullptr) {
      continue;
    }
    const Stretch s = tube.stretch(.25, .75);
    for (const bool at_end : {false, true}) {
      const SpinePoint y = evaluate(surface.spine, at_end ? .75 : .25);
      const auto value = [&](const Polynomial& p) { return at_end ? p.back() : p.front(); };
      Vec3 tangent;
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(mpq_class(value(s.points[k]) / value(s.weight)).get_d(), y.position[k], 1e-12);
        tangent[k] = value(s.tangent[k]).get_d();
      }
      EXPECT_LT((tangent.normalized() - y.first.normalized()).norm(), 1e-13);
    }
  }
}

TEST(Tube, turning_of_a_plane_polygon_is_its_angle) {
  const auto at = [](double angle) {
    return numbers::interval_vec(Vec3(std::cos(angle), std::sin(angle), 0));
  };
  const double found = turning({at(0), at(.5), at(1.2)});
  EXPECT_NEAR(found, 1.2, 1e-14);
  EXPECT_GE(found, 1.2 - 1e-16);
  EXPECT_NEAR(turning({at(0), at(.5), at(0)}), 1, 1e-14);
  EXPECT_EQ(turning({at(2)}), 0);
}

TEST(Tube, turning_bounds_that_of_the_spine) {
  for (const RingedSurface& surface : surfaces()) {
    double sampled = 0;
    for (int i = 0; i < 1000; ++i) {
      const SpinePoint y = evaluate(surface.spine, (i + .5) / 1000);
      sampled += curvature(y) * y.first.norm() / 1000;
    }
    EXPECT_GE(turning(Tube(surface).discs(0, 1).tangents), sampled - 1e-4);
  }
}

TEST(Tube, cones_are_lines_with_linear_radii) {
  const std::vector<bool> expected{true, true, false, false, false, false, false};
  const auto all = surfaces();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(Tube(all[i]).is_cone(), expected[i]) << i;
  }
  RingedSurface reducer = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  reducer.radius = CubicRadius{1, 2};
  EXPECT_FALSE(Tube(reducer).is_cone());
}

TEST(Tube, refuses_spines_and_radii_that_are_none) {
  RingedSurface surface = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  for (const BezierSpine& spine :
       {BezierSpine{{Vec3(0, 0, 0)}}, BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {1}},
        BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {1, 0}}}) {
    surface.spine = spine;
    EXPECT_THROW(Tube{surface}, Error);
  }
  surface = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  surface.radius = BezierRadius{};
  EXPECT_THROW(Tube{surface}, Error);
}

TEST(Tube, enclosed_holds_the_rational) {
  const mpq_class third(1, 3);
  const Interval found = enclosed(third);
  EXPECT_LT(mpq_class(found.lower), third);
  EXPECT_GT(mpq_class(found.upper), third);
  EXPECT_EQ(enclosed(.1).lower, .1);
  EXPECT_EQ(enclosed(.1).upper, .1);
}

// Discs whose tangents turn from one side of the plane across w to the other: between them is one
// that reaches as far as its radius, though none of the two does.
TEST(Tube, discs_that_turn_past_a_direction_reach_their_radius) {
  const IntervalVec with = numbers::interval_vec(Vec3(1, 0.125, 0)),
                    against = numbers::interval_vec(Vec3(-1, 0.125, 0));
  const IntervalVec origin = numbers::interval_vec(Vec3::Zero());
  for (const auto& tangents : {std::vector{with, against}, {against, with}}) {
    for (const double side : {1., -1.}) {
      const IntervalVec w = numbers::interval_vec(Vec3(side, 0, 0));
      EXPECT_GE(furthest({{origin}, tangents, Interval(2), 0}, w), 2);
    }
  }
  for (const IntervalVec& tangent : {with, against}) {
    const IntervalVec w = numbers::interval_vec(Vec3(1, 0, 0));
    EXPECT_LT(furthest({{origin}, {tangent, tangent}, Interval(2), 0}, w), 0.25);
  }
}

// Directions may be boxes: the bounds are those of the worst in them.
TEST(Tube, discs_of_a_wide_direction_reach_as_far_as_the_worst) {
  const IntervalVec origin = numbers::interval_vec(Vec3::Zero()),
                    wide{Interval(.75, 1), Interval(-.75, .75), 0};
  for (const double side : {1., -1.}) {
    const IntervalVec w = numbers::interval_vec(Vec3(side, 0, 0));
    EXPECT_GE(furthest({{origin}, {wide}, Interval(2), 0}, w), 2 * std::numbers::sqrt2 / 2);
  }
}

TEST(Tube, turning_between_boxes_is_the_most_there_is) {
  const IntervalVec x = numbers::interval_vec(Vec3::UnitX());
  const IntervalVec ahead{Interval(.5, 1), Interval(.25, .5), 0},
      behind{Interval(-1, -.5), Interval(.25, .5), 0};
  EXPECT_NEAR(turning({x, ahead}), std::atan2(.5, .5), 1e-12);
  EXPECT_NEAR(turning({x, behind}), std::atan2(.25, -1), 1e-12);
}

}  // namespace
}  // namespace dupin::verification
