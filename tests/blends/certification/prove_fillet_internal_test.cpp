#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certification/prove_fillet.h"
#include "dupin/kernel/error.h"
#include "support/fillet_loops.h"
#include "surfaces/fillet_mesh.h"

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
            EXPECT_LT(claims.contact.offset, 1e-11) << what;
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
  EXPECT_LT(more.contact.offset, 1e-11) << "which has nothing to do with it";
}

TEST(ProveFillet, leaves_undecided_what_takes_too_many_pairs) {
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  const LoopClaims claims = prove_loop(loop, mesh(128), {{}, 4, kTolerance});
  EXPECT_EQ(claims.regular.verdict, Verdict::proved);
  EXPECT_EQ(claims.embedded.verdict, Verdict::undecided);
  EXPECT_TRUE(claims.embedded.leaves.empty());
}

TEST(ProveFillet, refuses_balls_that_do_not_touch) {
  CanalFillet loop = test::loops_of_all_kinds().front().loop;
  loop.quadrics[0].radius += 2 * kTolerance;
  EXPECT_THROW((void)prove_loop(loop, mesh(128), {{}, 1 << 14, kTolerance}), Error);
}

}  // namespace
}  // namespace dupin::certification
