#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "certification/prove_hub.h"
#include "dupin/blends/junction.h"
#include "verification/hub_claims.h"

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

}  // namespace
}  // namespace dupin::verification
