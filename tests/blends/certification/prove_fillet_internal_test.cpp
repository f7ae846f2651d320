#include <gtest/gtest.h>

#include "certification/prove_fillet.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"
#include "support/fillet_loops.h"
#include "support/named_parts.h"
#include "surfaces/fillet_mesh.h"
#include "verification/claims/fillet_claims.h"
#include "verification/work.h"

namespace dupin::certification {
namespace {

constexpr double kTolerance = 0.02;

LoopMesh mesh(int rows) {
  LoopMesh mesh{{}, 10, 0x1p-20};
  for (int i = 0; i < rows; ++i) {
    mesh.rows.push_back(2 * std::numbers::pi * i / rows);
  }
  return mesh;
}

// Of all tees that are no folds everything is proved, nearly as far as another way proves it.
TEST(ProveFillet, proves_all_of_tees) {
  int proved = 0;
  for (const double ratio : {0.25, 0.75, 1.0}) {
    for (const double offset : {0.0, 0.25, 0.75}) {
      for (const double degrees : {90.0, 45.0}) {
        for (const double ball : {0.05, 0.5}) {
          for (const CanalFillet& loop :
               rolling_ball_fillets(test::cylinders(ratio, offset, degrees), ball * ratio * 4)) {
            const auto mesh = surfaces::fillet_mesh(loop, {kTolerance, {0.1, 0.1}, 0x1p-20});
            const LoopClaims claims = prove_loop(
                loop, {mesh.tessellation.knots, mesh.columns, 0x1p-20}, {{}, 1 << 14, kTolerance});
            const std::string what = std::to_string(ratio) + " " + std::to_string(offset) + " " +
                                     std::to_string(degrees) + " " + std::to_string(ball);
            EXPECT_EQ(claims.regular.verdict, Verdict::proved) << what;
            EXPECT_GT(claims.regular.margin, 0.96 * dupin::prove_regular(loop).regularity) << what;
            EXPECT_EQ(claims.embedded.verdict, Verdict::proved) << what;
            EXPECT_TRUE(claims.contact && claims.contact->offset < 1e-11) << what;
            // By second derivatives; the mesh was made with sharper bounds, by planes.
            EXPECT_TRUE(claims.mesh && claims.mesh->error_bound < 1.5 * kTolerance) << what;
            ++proved;
          }
        }
      }
    }
  }
  EXPECT_GE(proved, 50);
}

// Cones that pass through each other, and that are crossed beside their axes.
TEST(ProveFillet, proves_all_of_cones) {
  struct Row {
    Ring first, second;
    double ball;
  };
  const Ring run{{0, 0, 0}, {1, 0, 0}, 10, 0}, reducer{{0, 0, 0}, {1, 0, 0}, 9, -0.02};
  const auto branch = [](double offset, double degrees, double radius, double slope) {
    const double angle = degrees * std::numbers::pi / 180;
    return Ring{{0, 0, offset}, {std::cos(angle), std::sin(angle), 0}, radius, slope};
  };
  for (const auto& [first, second, ball] : {Row{run, branch(0, 60, 9, 0.05), 1},
                                            {run, branch(2, 90, 9.5, -0.01), 1},
                                            {run, branch(5, 60, 9, 0.05), 1},
                                            {reducer, branch(8, 90, 6, 0.03), 0.4},
                                            {reducer, branch(6, 90, 4, -0.02), 2},
                                            {run, branch(11, 45, 5, 0.02), 1}}) {
    for (const CanalFillet& loop : rolling_ball_fillets({first, second}, ball)) {
      const auto mesh = surfaces::fillet_mesh(loop, {kTolerance, {0.1, 0.1}, 0x1p-20});
      const LoopClaims claims = prove_loop(loop, {mesh.tessellation.knots, mesh.columns, 0x1p-20},
                                           {{}, 1 << 14, kTolerance});
      EXPECT_EQ(claims.regular.verdict, Verdict::proved) << second.radius;
      EXPECT_EQ(claims.embedded.verdict, Verdict::proved) << second.radius;
      EXPECT_TRUE(claims.mesh) << second.radius;
      // What is forged is refused.
      RegularClaim forged = claims.regular;
      EXPECT_TRUE(verification::regular_cells(loop, forged));
      forged.margin = dupin::prove_regular(loop).regularity / 0.9;
      EXPECT_FALSE(verification::regular_cells(loop, forged));
      forged = claims.regular;
      forged.leaves.erase(forged.leaves.begin() + 3);
      EXPECT_FALSE(verification::regular_cells(loop, forged)) << "a gap";
    }
  }
}

TEST(ProveFillet, proves_the_margin_that_is_asked_for_or_nothing) {
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  const double known = dupin::prove_regular(loop).regularity;
  const LoopClaims less = prove_loop(loop, mesh(128), {known / 2, 1 << 14, kTolerance});
  EXPECT_EQ(less.regular.verdict, Verdict::proved);
  EXPECT_EQ(less.regular.margin, known / 2);
  const LoopClaims more = prove_loop(loop, mesh(128), {known / 0.9 + 0.01, 1 << 14, kTolerance});
  EXPECT_EQ(more.regular.verdict, Verdict::undecided);
  EXPECT_TRUE(more.regular.leaves.empty());
  EXPECT_EQ(more.embedded.verdict, Verdict::undecided);
  EXPECT_FALSE(more.mesh);
  EXPECT_TRUE(more.contact && more.contact->offset < 1e-11) << "which has nothing to do with it";
}

TEST(ProveFillet, leaves_undecided_what_takes_too_many_pairs) {
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  const LoopClaims claims = prove_loop(loop, mesh(128), {{}, 4, kTolerance});
  EXPECT_EQ(claims.regular.verdict, Verdict::proved);
  EXPECT_EQ(claims.embedded.verdict, Verdict::undecided);
  EXPECT_TRUE(claims.embedded.leaves.empty());
}

// A cone as thick as the pipe where it leaves it: the balls' centres turn sharply where both all
// but touch, which took more work than a certificate may.
TEST(ProveFillet, proves_all_where_cones_all_but_touch) {
  for (const double missing : {0.001, 0.0001}) {
    const Assembly assembly{"",
                            Unit::millimetre,
                            0.1,
                            {},
                            {test::pipe("run", {-60, 0, 0}, {60, 0, 0}, 10),
                             {"cone", ConeBetween{{0, 0, 0}, {0, 0, 60}, 10 - missing, 9.5}},
                             test::fillet("fillet", "run", "cone", 2)}};
    const ResolvedAssembly resolved = resolve(assembly);
    const CanalFillet& loop = resolved.fillets.at(0).shape.loops.at(0);
    const verification::WorkLimit limit(CertificateLimits::kWork);
    const std::uint64_t before = limit.left();
    const LoopClaims claims = prove_loop(loop, mesh(512), {{}, 1 << 14, 0.1});
    EXPECT_EQ(claims.regular.verdict, Verdict::proved) << missing;
    EXPECT_EQ(claims.embedded.verdict, Verdict::proved) << missing;
    ASSERT_TRUE(claims.contact) << missing;
    EXPECT_LT(claims.contact->offset, 1e-11) << missing;
    EXPECT_TRUE(verification::follows(loop, *claims.contact));
    EXPECT_LT(before - limit.left(), CertificateLimits::kWork / 8) << missing;
  }
}

TEST(ProveFillet, refuses_balls_that_do_not_touch) {
  CanalFillet loop = test::loops_of_all_kinds().front().loop;
  loop.quadrics[0].radius += 2 * kTolerance;
  EXPECT_THROW((void)prove_loop(loop, mesh(128), {{}, 1 << 14, kTolerance}), Error);
}

}  // namespace
}  // namespace dupin::certification
