#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "certification/prove_hub.h"
#include "dupin/blends/junction.h"
#include "verification/claims/hub_claims.h"

namespace dupin::verification {
namespace {

Ring towards_origin(const Vec3& from, double radius, double distance) {
  const Vec3 unit = from.normalized();
  return {distance * unit, -unit, radius};
}

Junction skew() {
  return junction_of(std::vector<Ring>{towards_origin({1, 0.1, 0}, 1, 9),
                                       {{-8, 0.3, 0}, Vec3(1, 0, 0.05).normalized(), 0.8, 0.05},
                                       towards_origin({0.2, 1, 0.3}, 0.6, 7),
                                       towards_origin({0, -0.4, 1}, 0.9, 8)});
}

CertifiedPart arm_part(const Junction& junction, std::size_t i) {
  return {"arm", "junction", tube(junction.arms[i]), {}};
}

Solid arm_of(const Junction& junction, std::size_t i) { return Solid(arm_part(junction, i)); }

CyclidePiece straight(const PeVector& first, const PeVector& last) {
  return test::cyclide_piece(PeArc::from(first, {Vec3::UnitX(), 0}, last));
}

TEST(HubClaims, arms_are_those_that_end_in_the_very_sphere) {
  const Junction junction = skew();
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const Solid arm = arm_of(junction, i);
    EXPECT_TRUE(is_arm(arm, junction.hub));
    Sphere other = junction.hub;
    other.radius = std::nextafter(other.radius, 9);
    EXPECT_FALSE(is_arm(arm, other));
    other = junction.hub;
    other.center.z() = std::nextafter(other.center.z(), 9);
    EXPECT_FALSE(is_arm(arm, other));
  }
  EXPECT_FALSE(is_arm(Solid({"ball", "sphere", junction.hub, {}}), junction.hub));
}

// By angles, which the exact criterion knows nothing of.
TEST(HubClaims, caps_are_disjoint_where_their_angles_say_so) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  int disjoint = 0;
  for (int i = 0; i < 200; ++i) {
    const auto arm = [&] {
      const Ring end = towards_origin({any(random), any(random), any(random)}, 1, 6);
      const PeArc collar = PeArc::from(contact_sphere(end), contact_tangent(end),
                                       {Vec3(0, 0, 0), 1.5 + 2 * std::abs(any(random))});
      return JunctionArm{end, {}, collar};
    };
    JunctionArm one = arm(), other = arm();
    const double angle = std::acos(cap_circle(one).normal.dot(cap_circle(other).normal));
    const double gap = angle - cap_angle(one) - cap_angle(other);
    if (std::abs(gap) > 1e-12) {
      const auto solid = [](const JunctionArm& a) { return Solid({"", "", tube(a), {}}); };
      EXPECT_EQ(caps_are_disjoint(solid(one), solid(other)), gap > 0);
      disjoint += gap > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(disjoint, 40);
  EXPECT_LT(disjoint, 160);
}

TEST(HubClaims, of_arms_follow_and_of_nothing_else) {
  const Junction junction = skew();
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const Solid arm = arm_of(junction, i);
    const ClearanceClaim claim = certification::prove_at_hub(arm, junction.hub, 1 << 12);
    ASSERT_EQ(claim.verdict, Verdict::proved);
    EXPECT_LT(claim.leaves.size(), 400);
    EXPECT_TRUE(follows_at_hub(arm, junction.hub, claim));
    const std::vector<std::function<void(ClearanceClaim&)>> forgeries{
        [](ClearanceClaim& c) { c.leaves.pop_back(); },
        [](ClearanceClaim& c) { c.leaves.erase(c.leaves.begin()); },
        [](ClearanceClaim& c) { c.leaves.front().first.from = 0x1p-30; },
        [](ClearanceClaim& c) { c.leaves.front().second.to = 0.5; },
        [](ClearanceClaim& c) { c.leaves.front().direction = Vec3::UnitX(); },
        [](ClearanceClaim& c) {
          c.leaves = {{{0, 1}, {0, 1}, {}}};
        },
        [](ClearanceClaim& c) { c.distance = 1e-9; },
        [](ClearanceClaim& c) { c.verdict = Verdict::refuted; },
        [](ClearanceClaim& c) { c.verdict = Verdict::undecided; },
    };
    for (std::size_t k = 0; k < forgeries.size(); ++k) {
      ClearanceClaim forged = claim;
      forgeries[k](forged);
      if (k == 5 && arm.length() == 1) {
        continue;  // one leaf may do
      }
      EXPECT_FALSE(follows_at_hub(arm, junction.hub, forged)) << k;
    }
  }
}

// A ball that a pipe passes through holds circles of it, wherever it ends.
TEST(HubClaims, circles_within_the_hub_are_not_outside) {
  const Ring end = towards_origin({1, 0, 0}, 1, 6);
  const PeVector start = contact_sphere(end), tangent = contact_tangent(end);
  for (const double y : {0.0, 0.5, 2.0, 4.0}) {
    // Collars that turn, ones that lead through the ball from behind, and harmless ones.
    const PeVector hub{Vec3(2, y, 0), 1.7};
    const PeArc collar = PeArc::from(start, tangent, hub);
    const Solid arm({"", "", tube(JunctionArm{end, {}, collar}), {}});
    bool is_outside = true;
    for (int i = 0; i < 400 && is_outside; ++i) {
      const Ring circle = circle_at(collar, i / 400.0);
      const Vec3 u = circle.normal.unitOrthogonal(), v = circle.normal.cross(u);
      for (int k = 0; k < 90; ++k) {
        const double a = k * std::numbers::pi / 45;
        const Vec3 p = circle.center + circle.radius * (std::cos(a) * u + std::sin(a) * v);
        is_outside = is_outside && (p - hub.m).norm() > hub.r;
      }
    }
    const auto claim = certification::prove_at_hub(arm, {hub.m, hub.r}, 1 << 12);
    EXPECT_EQ(claim.verdict == Verdict::proved, is_outside) << y;
  }
}

// A quarter of a torus, from balls of radius 1 whose centres are so far from its axis: of those
// that hold the axis, circles reach into the last ball, by little where it is just inside.
TEST(HubClaims, arms_that_bend_into_the_hub_are_not_outside) {
  for (const double bend : {.5, .98, 1.5}) {
    const CyclidePiece quarter{{Vec3(bend, 0, 0), -Vec3::UnitY(), 1},
                               {Vec3(0, bend, 0), -Vec3::UnitX(), 1},
                               {Vec3(bend, 0, 0), 1},
                               {Vec3::UnitY(), 0},
                               {Vec3(0, bend, 0), 1},
                               std::numbers::sqrt2 * bend};
    const Solid arm = test::solid(quarter);
    const Sphere hub{Vec3(0, bend, 0), 1};
    ASSERT_TRUE(is_arm(arm, hub));
    for (const int cells : {1, 4, 16, 64}) {
      for (int i = 0; i < cells; ++i) {
        const bool outside = keeps_outside(arm, {double(i) / cells, double(i + 1) / cells}, hub);
        EXPECT_TRUE(bend > 1 || !outside) << bend << " " << i << "/" << cells;
        EXPECT_TRUE(bend < 1 || cells < 64 || outside) << i;
      }
    }
  }
}

// A pipe that begins a little inside of the hub's ball, on the far side, turns round and comes back
// to end in it: its circles are outside, and the ball comes in through the disc where it begins.
TEST(HubClaims, arms_that_begin_in_the_hub_are_not_outside) {
  constexpr int kLeaves = 1024;  // of a piece
  for (const double begin : {1.9, 2.1}) {
    const Sphere hub{Vec3::Zero(), 2};
    Chain chain;
    PeVector from{Vec3(begin, 0, 0), 1}, tangent{Vec3::UnitX(), 0};
    for (const PeVector& to : std::vector<PeVector>{{Vec3(begin + 10, 10, 0), 1},
                                                    {Vec3(begin, 20, 0), 1},
                                                    {Vec3(-2.5, 20, 0), 1},
                                                    {Vec3(-12.5, 10, 0), 1},
                                                    {Vec3(-2.5, 0, 0), 1},
                                                    {hub.center, hub.radius}}) {
      const PeArc arc = PeArc::from(from, tangent, to);
      chain.pieces.emplace_back(test::cyclide_piece(arc));
      tangent = arc.end_tangent();
      from = to;
    }
    const Solid arm({"", "", chain, {}});
    ASSERT_TRUE(is_arm(arm, hub));
    EXPECT_EQ(begins_outside(arm, hub), begin > 2);
    ClearanceClaim claim{0, 1, Verdict::proved, 0, {}, {}};
    for (double k = 0; k < kLeaves * arm.length(); ++k) {
      claim.leaves.push_back({{k / kLeaves, (k + 1) / kLeaves}, {0, 1}, {}});
      EXPECT_TRUE(keeps_outside(arm, claim.leaves.back().first, hub)) << k;
    }
    EXPECT_EQ(follows_at_hub(arm, hub, claim), begin > 2);
    EXPECT_EQ(certification::prove_at_hub(arm, hub, 1 << 12).verdict,
              begin > 2 ? Verdict::proved : Verdict::undecided);
  }
}

// A disc is as far as its nearest point, be it on its circle or within, and what is behind the
// last circle, at x = 8, does not count.
TEST(HubClaims, arms_begin_outside_where_the_nearest_point_of_the_disc_is) {
  const auto begins = [](double begin, const Sphere& hub) {
    return begins_outside(test::solid(straight({{begin, 0, 0}, 1}, {{8, 0, 0}, 1})), hub);
  };
  EXPECT_TRUE(begins(0, {{8, 0, 0}, 20})) << "all of the disc is behind";
  EXPECT_TRUE(begins(7, {{8, 0, 0}, 20}));
  const Solid back = test::solid(straight({{0, 0, 0}, 1}, {{8, 0, 0}, 1}),
                                 straight({{-8, 9, 0}, 1}, {{-1, 9, 0}, 1}));
  const auto backwards = [&](const Sphere& hub) { return begins_outside(back, hub); };
  EXPECT_TRUE(backwards({{-2.001, .5, 0}, 2}));
  EXPECT_FALSE(backwards({{-1.999, .5, 0}, 2})) << "in front of x = -1";
  EXPECT_TRUE(backwards({{2.001, .5, 0}, 2})) << "the hub on the other side";
  EXPECT_FALSE(backwards({{1.999, .5, 0}, 2}));
  EXPECT_TRUE(backwards({{-3, 5.001, 0}, 5}));
  EXPECT_FALSE(backwards({{-3, 4.999, 0}, 5}));
  EXPECT_TRUE(backwards({{0, 3.001, 0}, 2}));
  EXPECT_FALSE(backwards({{0, 2.999, 0}, 2}));
  EXPECT_FALSE(backwards({{0, 3.1, 0}, 2.1})) << "what touches";
  EXPECT_FALSE(begins_outside(test::ball({0, 0, 0}, 1), {{9, 0, 0}, 1})) << "no disc";
}

// All of the disc is in the hub. By how much it is ahead of the last circle is less than rounding.
TEST(HubClaims, arms_begin_in_front_of_the_last_circle_by_however_little) {
  for (double x = .1; x < 2; x += .1) {
    const double ahead = std::nextafter(x, 9);
    EXPECT_FALSE(begins_outside(test::solid(straight({{ahead, 0, 0}, 1}, {{9, 0, 0}, 1}),
                                            straight({{-8, 9, 0}, 1}, {{x, 9, 0}, 1})),
                                {{x, 0, 0}, 20}))
        << x;
  }
}

TEST(HubClaims, arms_without_a_first_or_a_last_disc_begin_nowhere) {
  const CyclidePiece pipe = straight({{-8, 0, 0}, 1}, {{-2, 0, 0}, 1});
  CyclidePiece none = pipe;
  none.tangent.r = 2;  // spheres that hold each other
  const Sphere far{{0, 90, 0}, 1};
  EXPECT_TRUE(begins_outside(test::solid(pipe, pipe), far));
  EXPECT_FALSE(begins_outside(test::solid(none, pipe), far));
  EXPECT_FALSE(begins_outside(test::solid(pipe, none), far));
}

// Corners of a regular polygon on a great circle of the hub, with its middle the deepest.
TEST(HubClaims, of_a_mesh_bound_its_triangles) {
  const Sphere hub{{1, 2, 3}, 5};
  for (const std::uint32_t n : {3U, 8U, 40U, 1000U}) {
    MeshClaim claim{n, 0, {}, 0};
    const double circle = 5 * std::sin(std::numbers::pi / n);
    const double depth = 5 - std::sqrt(25 - circle * circle);
    claim.error_bound = depth;
    EXPECT_FALSE(follows_of_hub(hub, claim));
    claim.error_bound = 1.1181 * depth + 1e-12;
    EXPECT_TRUE(follows_of_hub(hub, claim));
    claim.grid = 0.01;
    EXPECT_FALSE(follows_of_hub(hub, claim));
    claim.error_bound += 0.00867;
    EXPECT_TRUE(follows_of_hub(hub, claim));
    claim.knots = {0, 1};
    EXPECT_FALSE(follows_of_hub(hub, claim));
  }
  EXPECT_FALSE(follows_of_hub(hub, {2, 0, {}, 1e9}));
  EXPECT_FALSE(follows_of_hub(hub, {8, -1, {}, 1e9}));
  EXPECT_FALSE(follows_of_hub(hub, {8, 0, {}, std::nan("")}));
}

TEST(HubClaims, arms_are_open_and_full) {
  const Junction junction = skew();
  CertifiedPart part = arm_part(junction, 0);
  EXPECT_TRUE(is_arm(Solid(part), junction.hub));
  std::get<Chain>(part.shape).wall = .01;
  EXPECT_FALSE(is_arm(Solid(part), junction.hub));
  std::get<Chain>(part.shape).wall = 0;
  std::get<Chain>(part.shape).closed = true;
  EXPECT_FALSE(is_arm(Solid(part), junction.hub));
  EXPECT_FALSE(is_arm(test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1)), {{1, 0, 0}, 1}));
}

// Of a stretch that is not the last one, all circles count: here those in its middle.
TEST(HubClaims, pieces_before_the_last_one_keep_outside_too) {
  const CyclidePiece pipe = straight({{-8, 0, 0}, 1}, {{8, 0, 0}, 1});
  const Solid arm = test::solid(pipe, pipe);
  const Sphere hub{{0, 0, 0}, .5};
  EXPECT_TRUE(keeps_outside(arm, {0, .25}, hub));
  EXPECT_TRUE(keeps_outside(arm, {.75, 1}, hub));
  EXPECT_FALSE(keeps_outside(arm, {.46875, .53125}, {{0, 1, 0}, .5}));
  EXPECT_FALSE(keeps_outside(arm, {.25, .75}, {{0, 1, 0}, .5}));
  EXPECT_FALSE(keeps_outside(arm, {0, 1}, {{0, 1, 0}, .5}));
  EXPECT_TRUE(keeps_outside(arm, {.25, .5}, {{0, 4, 0}, .5}));
  EXPECT_FALSE(keeps_outside(arm, {.25, .25}, {{0, 4, 0}, .5})) << "no stretch";
  EXPECT_FALSE(keeps_outside(arm, {.5, 1.5}, {{0, 40, 0}, .5})) << "of two pieces";
  EXPECT_FALSE(keeps_outside(test::solid(test::cylinder({-1, 0, 0}, {1, 0, 0}, 1)), {0, 1},
                             {{0, 40, 0}, .5}));
}

// Spheres that hold each other, or have no radius, have no circles that could keep outside.
TEST(HubClaims, spheres_without_circles_keep_outside_of_nothing) {
  const CyclidePiece pipe = straight({{-8, 0, 0}, 1}, {{8, 0, 0}, 1});
  CyclidePiece grows = pipe;
  grows.first = {{0, 0, 0}, 1};
  grows.tangent = {Vec3(.5, 0, 0), 1};
  grows.last = {{4, 0, 0}, 1};
  grows.chord = 4;
  const Sphere far{{0, 90, 0}, 1};
  const Solid growing = test::solid(grows, pipe);
  EXPECT_TRUE(keeps_outside(growing, {.4375, .5}, far));
  double without = 0, with = .5;  // where circles begin
  while (with - without > 0x1p-30) {
    const double middle = (without + with) / 2;
    (keeps_outside(growing, {middle, middle + 0x1p-32}, far) ? with : without) = middle;
  }
  EXPECT_GT(without, .125);
  EXPECT_FALSE(keeps_outside(growing, {without - 0x1p-20, with + 0x1p-20}, far));
  EXPECT_TRUE(keeps_outside(growing, {with + 0x1p-20, with + 0x1p-19}, far));
  CyclidePiece shrinks = pipe;
  shrinks.last.r = -1;
  const Solid shrinking = test::solid(shrinks, pipe);
  EXPECT_TRUE(keeps_outside(shrinking, {.25, .375}, far));
  EXPECT_FALSE(keeps_outside(shrinking, {.5625, .75}, far));
  EXPECT_FALSE(keeps_outside(shrinking, {.875, 1}, far));
}

// Spheres of radius 1 at both ends of the x axis, whose end tangents may have no circle.
TEST(HubClaims, caps_are_those_of_circles) {
  const auto arm = [](double side, double slope) {
    CyclidePiece piece = straight({{-8, 0, 0}, 1}, {{-2, 0, 0}, 1});
    piece.first = {Vec3(-8 * side, 0, 0), 1};
    piece.last = {Vec3::Zero(), 1};
    piece.tangent = {Vec3(side, 0, 0), slope};
    return test::solid(piece);
  };
  EXPECT_TRUE(caps_are_disjoint(arm(1, -.5), arm(-1, -.5)));
  EXPECT_FALSE(caps_are_disjoint(arm(1, -2), arm(-1, -.5)));
  EXPECT_FALSE(caps_are_disjoint(arm(1, -.5), arm(-1, -2)));
  EXPECT_FALSE(caps_are_disjoint(arm(1, -2), arm(-1, -2)));
  EXPECT_FALSE(caps_are_disjoint(arm(1, -.5), arm(1, -.5))) << "one cap";
  EXPECT_FALSE(caps_are_disjoint(arm(1, .5), arm(-1, .5))) << "more than half of the hub each";
}

TEST(HubClaims, leaves_more_than_are_needed_must_hold_too) {
  const Junction junction = skew();
  const Solid arm = arm_of(junction, 0);
  const ClearanceClaim claim = certification::prove_at_hub(arm, junction.hub, 1 << 12);
  ASSERT_TRUE(follows_at_hub(arm, junction.hub, claim));
  const ParameterInterval good = claim.leaves.front().first;
  ASSERT_EQ(good.from, 0);
  for (const DiscPairs& leaf : std::vector<DiscPairs>{{{0, 0}, {0, 1}, {}},
                                                      {{0x1p-70, good.to}, {0, 1}, {}},
                                                      {{0, arm.length() + 1}, {0, 1}, {}},
                                                      {good, {0, 2}, {}},
                                                      {good, {.5, .25}, {}},
                                                      {good, {0, 1}, Vec3::UnitX()}}) {
    ClearanceClaim more = claim;
    more.leaves.push_back(leaf);
    EXPECT_FALSE(follows_at_hub(arm, junction.hub, more)) << leaf.first.from << leaf.second.to;
  }
}

TEST(HubClaims, of_a_mesh_have_no_more_segments_than_the_limit) {
  const Sphere hub{{1, 2, 3}, 5};
  EXPECT_TRUE(follows_of_hub(hub, {CertificateLimits::kSegments, 0, {}, 1}));
  EXPECT_FALSE(follows_of_hub(hub, {CertificateLimits::kSegments + 1, 0, {}, 1}));
}

}  // namespace
}  // namespace dupin::verification
