#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "blends/canal/residuals.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin {
namespace {

using test::kPi;

Ring ring(const Vec3& center, const Vec3& normal, double radius, double slope = 0) {
  return {center, normal.normalized(), radius, slope};
}

struct Least {
  double regularity = 1e300, radius = 1e300;
};

Least sampled(const CanalFillet& fillet) {
  Least least;
  for (int k = 0; k < 5000; ++k) {
    const MovingBall at = ball(fillet, 2 * kPi * k / 5000);
    const ContactArc arc = contact_arc(fillet.quadrics, at);
    least.regularity = std::min(least.regularity, least_regularity(at, arc));
    least.radius = std::min(least.radius, at.radius);
  }
  return least;
}

std::vector<CanalFillet> regular_fillets() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), slanted(.5, std::sqrt(.75), 0);
  const Ring run = ring(Vec3::Zero(), x, 2), branch = ring(Vec3(0, 0, .3), slanted, 1);
  const Ring cone = ring(Vec3(0, 4, .1), y, 1, -.1);
  std::vector<CanalFillet> result;
  const auto add = [&](std::vector<CanalFillet> fillets) {
    result.insert(result.end(), fillets.begin(), fillets.end());
  };
  add(rolling_ball_fillets({run, branch}, .3));
  add(rolling_ball_fillets({run, ring(Vec3(0, 0, 1.5), slanted, 1)}, .2));
  add(rolling_ball_fillets({run, ring(Vec3(1, 0, 0), slanted, 2)}, .3));  // equal
  add(rolling_ball_fillets({cone, run}, .3));
  add(rational_fillets({run, branch}, .3));
  add(rational_fillets({run, cone}, .2));
  add(rational_fillets({ring(2 * x, y, 1), ring(Vec3(-2, 1, 0), y, 1, 1)}, .5));
  return result;
}

TEST(ProveRegular, BoundsWhatIsSampledFromBelow) {
  for (const CanalFillet& fillet : regular_fillets()) {
    SCOPED_TRACE(fillet.motion.index());
    const CanalRegularity proof = prove_regular(fillet);
    const Least least = sampled(fillet);
    EXPECT_EQ(proof.verdict, Verdict::proved);
    EXPECT_LE(proof.regularity, least.regularity);
    EXPECT_GE(proof.regularity, .89 * least.regularity);
    EXPECT_LE(proof.radius, least.radius);
    EXPECT_GT(proof.radius, 0);
    EXPECT_LT(proof.leaves, 3000) << proof.leaves;
  }
}

// A cone that touches the run from inside on one side but for a gap, or sticks out by that: the
// ball turns sharply there.
TEST(ProveRegular, ProvesFilletsOfConesThatAllButTouch) {
  const Ring run = ring(Vec3::Zero(), Vec3::UnitX(), 10);
  for (const double slope : {-.1, .3}) {
    for (const double gap : {-1e-5, -1e-3, 1e-3, 1e-5, 1e-7}) {
      SCOPED_TRACE(testing::Message() << slope << ' ' << gap);
      const double touching = 10 * std::hypot(1, slope) - 1;
      const Ring cone = ring(Vec3(0, 1, 0), Vec3::UnitZ(), touching + gap, slope);
      for (const CanalFillet& loop : rolling_ball_fillets({run, cone}, 1)) {
        const CanalRegularity proof = prove_regular(loop);
        EXPECT_EQ(proof.verdict, Verdict::proved);
        EXPECT_GT(proof.regularity, .5);
        EXPECT_LT(proof.leaves, 800);
      }
    }
  }
}

TEST(ProveRegular, RefutesAFilletThatFolds) {
  CanalFillet fillet =
      rational_fillet({ring(Vec3::Zero(), Vec3::UnitX(), 4), ring(Vec3::Zero(), Vec3::UnitY(), 2)},
                      {1, .45, 1, .45}, 1);
  auto& motion = std::get<RationalCrossing>(fillet.motion);
  for (const double g : {.4, .45}) {
    motion.size = {g, 0, 0, 0};
    const CanalRegularity proof = prove_regular(fillet);
    EXPECT_EQ(proof.verdict, Verdict::refuted) << g;
    EXPECT_LE(proof.regularity, 0);
    const MovingBall at = ball(fillet, proof.where.from);
    EXPECT_LT(least_regularity(at, contact_arc(fillet.quadrics, at)), 1e-12);
  }
  motion.size = {.35, 0, 0, 0};
  EXPECT_EQ(prove_regular(fillet).verdict, Verdict::proved);
}

TEST(ProveRegular, RefutesBallsOfNoRadius) {
  CanalFillet fillet =
      rational_fillet({ring(Vec3::Zero(), Vec3::UnitX(), 4), ring(Vec3::Zero(), Vec3::UnitY(), 2)},
                      {1, .45, 1, .45}, 1);
  // Below the admissible 2 - sqrt(3) the radius is negative somewhere.
  std::get<RationalCrossing>(fillet.motion).size = {.26, 0, 0, 0};
  EXPECT_EQ(prove_regular(fillet).verdict, Verdict::refuted);
  std::get<RationalCrossing>(fillet.motion).size = {.27, 0, 0, 0};
  EXPECT_EQ(prove_regular(fillet).verdict, Verdict::proved);
}

TEST(ProveRegular, RefutesATightConstantBall) {
  // The acute corner of a slanted branch: a ball of that size turns more sharply than it is large.
  const Ring run = ring(Vec3::Zero(), Vec3::UnitX(), 2);
  bool seen = false;
  for (const double radius : {.2, .5, 1.0, 2.0, 4.0}) {
    for (const CanalFillet& fillet : rolling_ball_fillets(
             {run, ring(Vec3(0, 0, 0), Vec3(std::cos(.5), std::sin(.5), 0), 1)}, radius)) {
      const CanalRegularity proof = prove_regular(fillet);
      const Least least = sampled(fillet);
      EXPECT_EQ(proof.verdict, least.regularity > 0 ? Verdict::proved : Verdict::refuted) << radius;
      seen = seen || proof.verdict == Verdict::refuted;
    }
  }
  EXPECT_TRUE(seen);
}

// The second one all but touches the first from inside, within 2e-11: where the ball turns sharply
// bounds stay lowest, and it folds elsewhere.
TEST(ProveRegular, RefutesFoldsThatAreNotWhereBoundsAreLowest) {
  const Ring one{{-0.39030939612351878, 1.8529161189017982, 1.5812821819215592},
                 {0.015981412062650649, -0.99986545193264409, 0.0036976343806694794},
                 9.6046264285854974,
                 0};
  const Ring two{{-8.5855106680646038, -18.803489808967154, 6.2805057539561835},
                 {0.096171215311831315, 0.94396655228497894, -0.31571861762122216},
                 3.1264786748352709,
                 0};
  const std::vector<CanalFillet> loops = rolling_ball_fillets({one, two}, 1.3962363459226481);
  ASSERT_EQ(loops.size(), 2);
  for (const CanalFillet& fillet : loops) {
    EXPECT_LT(sampled(fillet).regularity, 0);
    EXPECT_EQ(prove_regular(fillet).verdict, Verdict::refuted);
  }
}

}  // namespace
}  // namespace dupin
