#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "surfaces/pieces/piece_operations.h"

namespace dupin::surfaces {
namespace {

using std::numbers::pi;

// About a circle of radius 4: a margin of 1 - radius / 4 everywhere.
RingedSurface bend(const RadiusLaw& radius) {
  return {{}, {}, ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 2}, radius};
}

void expect_partition(const std::vector<ParameterInterval>& leaves) {
  ASSERT_FALSE(leaves.empty());
  EXPECT_EQ(leaves.front().from, 0);
  EXPECT_EQ(leaves.back().to, 1);
  for (std::size_t i = 1; i < leaves.size(); ++i) {
    EXPECT_EQ(leaves[i - 1].to, leaves[i].from);
  }
}

TEST(PieceOperations, margin_of_tubes_is_the_least_of_them) {
  EXPECT_NEAR(nearly_largest_margin({bend(ConstantRadius{1})}), .75, 1e-3);
  EXPECT_LT(nearly_largest_margin({bend(ConstantRadius{1})}), .75);
  EXPECT_NEAR(nearly_largest_margin({bend(ConstantRadius{1}), bend(ConstantRadius{3})}), .25, 1e-3);
  EXPECT_EQ(nearly_largest_margin({bend(ConstantRadius{5})}), 0) << "none at all";
}

TEST(PieceOperations, margins_of_tubes_are_proved_on_leaves_common_to_all) {
  const RingedSurface grows = bend(BezierRadius{{.5, .5, 2}}),
                      falls = bend(BezierRadius{{3, 1, 1}});
  const ProvedStretches one = prove_margin({grows}, .45), two = prove_margin({falls}, .2),
                        both = prove_margin({grows, falls}, .2);
  for (const ProvedStretches& proof : {one, two, both}) {
    EXPECT_EQ(proof.verdict, Verdict::proved);
    expect_partition(proof.leaves);
  }
  EXPECT_GE(both.leaves.size(), two.leaves.size());
  // The first fails where its radius is over 2.2, so that .45 is refuted of it alone; of several
  // nobody knows which one a checker looks at.
  const RingedSurface thick = bend(BezierRadius{{.5, .5, 3}});
  const ProvedStretches alone = prove_margin({thick}, .45),
                        among = prove_margin({grows, thick}, .45);
  EXPECT_EQ(alone.verdict, Verdict::refuted);
  EXPECT_GT(dupin::evaluate(thick.radius, alone.where.to).value, 2.2);
  EXPECT_EQ(among.verdict, Verdict::undecided);
  EXPECT_TRUE(alone.leaves.empty() && among.leaves.empty());
  // A radius that vanishes has every margin, but is none.
  EXPECT_NE(prove_margin({bend(BezierRadius{{1, 0}})}, .5).verdict, Verdict::proved);
}

// Least at .4, off by a share of the stretch as interval bounds are.
double lower_bound(const ParameterInterval& t) {
  const double nearest = std::clamp(.4, t.from, t.to);
  return .3 + (nearest - .4) * (nearest - .4) - .5 * size(t);
}

TEST(PieceOperations, margins_of_bounds_are_proved_by_halving) {
  const double margin = nearly_largest_margin(lower_bound);
  EXPECT_LT(margin, .3);
  EXPECT_GT(margin, .28);
  const ProvedStretches proof = prove_margin(lower_bound, margin);
  EXPECT_EQ(proof.verdict, Verdict::proved);
  expect_partition(proof.leaves);
  for (const ParameterInterval& leaf : proof.leaves) {
    EXPECT_GT(lower_bound(leaf), margin);
    const double twice = 2 * size(leaf), from = std::floor(leaf.from / twice) * twice;
    EXPECT_LE(lower_bound({from, from + twice}), margin) << "halved for nothing";
  }
  // With room to prove it where the bound is nowhere more than the margin.
  const MarginOver flat = [](const ParameterInterval&) { return .5; };
  EXPECT_EQ(prove_margin(flat, nearly_largest_margin(flat)).leaves.size(), 1U);
  const ProvedStretches fails = prove_margin(lower_bound, .31);
  EXPECT_EQ(fails.verdict, Verdict::undecided);
  EXPECT_TRUE(fails.leaves.empty());
  EXPECT_NEAR(fails.where.from, .4, .11);  // .1^2 more than the least is enough
  EXPECT_EQ(nearly_largest_margin(MarginOver([](const ParameterInterval&) { return -1.; })), 0);
}

TEST(PieceOperations, margin_of_a_pace_is_of_the_largest_radius_and_slowest_advance) {
  EXPECT_NEAR(margin_of(DiscPace{4, 9, 1, {.5, 1}, 1}), .75, 1e-14);
  EXPECT_LE(margin_of(DiscPace{3, 0, 1, {.5, 1}, 1}), 2. / 3);
  EXPECT_LE(margin_of(std::nullopt), 0);
  EXPECT_LE(margin_of(DiscPace{0, 0, 0, {1, 1}, 1}), 0);
  EXPECT_LE(margin_of(DiscPace{1, 0, 0, {0, 1}, 1}), 0);
}

TEST(PieceOperations, largest_angle_is_an_upper_bound) {
  EXPECT_EQ(largest_angle(0, 1), 0);
  for (const auto& [y, x, angle] : {std::tuple(numbers::Interval(1), numbers::Interval(1), pi / 4),
                                    {numbers::Interval(0, 1), numbers::Interval(-1, 2), pi},
                                    {numbers::Interval(0, 1), numbers::Interval(1, 2), pi / 4},
                                    {numbers::Interval(1), numbers::Interval(-1), 3 * pi / 4}}) {
    for (const double at : {y.lower, y.upper}) {
      for (const double on : {x.lower, x.upper}) {
        EXPECT_GE(largest_angle(y, x), std::atan2(at, on));
      }
    }
    EXPECT_LE(largest_angle(y, x), angle * (1 + 1e-15)) << angle;
  }
}

TEST(PieceOperations, end_rings_are_seen_in_the_direction_of_travel) {
  const Ring ring{Vec3(1, 2, 3), Vec3::UnitX(), 2, .25};
  const EndRing start{ring, End::start}, end{ring, End::end};
  EXPECT_EQ(start.parameter(), 0);
  EXPECT_EQ(end.parameter(), 1);
  EXPECT_EQ(start.travel()[0].lower, -1);
  EXPECT_EQ(end.travel()[0].lower, 1);
  EXPECT_EQ(start.slope(), -.25);
  EXPECT_EQ(end.slope(), .25);
  const double off = offset(end, numbers::interval_vec(Vec3(1, 5, 7)), {1.5, 2.25});
  EXPECT_NEAR(off, 5.5, 1e-14);
  EXPECT_GE(off, 5.5);
  // A canal leaves along its normal, its radius growing by the slope.
  const MovingRing motion = leaving_canal(ring);
  EXPECT_EQ(motion.center, ring.center);
  EXPECT_EQ(motion.normal, ring.normal);
  EXPECT_EQ(motion.radius, ring.radius);
  EXPECT_LT(motion.center_rate.cross(ring.normal).norm(), 1e-15);
  EXPECT_NEAR(motion.radius_rate / motion.center_rate.dot(ring.normal), .25, 1e-15);
}

TEST(PieceOperations, stored_ends_are_those_that_spines_have_bitwise) {
  const Vec3 from(1, 2, 3), to(4, 5, 7);
  for (const Spine& spine :
       {Spine(LineSpine{from, to}), Spine(HermiteSpine{from, to, Vec3::UnitX(), Vec3::UnitY()}),
        Spine(BezierSpine{{from, Vec3(0, 0, 0), to}})}) {
    EXPECT_EQ(stored_end(spine, End::start), from);
    EXPECT_EQ(stored_end(spine, End::end), to);
  }
  EXPECT_FALSE(stored_end(bend(ConstantRadius{1}).spine, End::end).has_value());
}

}  // namespace
}  // namespace dupin::surfaces
