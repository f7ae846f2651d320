#include <gtest/gtest.h>

#include "certification/checked_claims.h"
#include "dupin/kernel/error.h"

namespace dupin::certification {
namespace {

CertifiedPart pipe(double height) {
  const Vec3 from(0, 0, height), to(4, 0, height), x = Vec3::UnitX();
  CertifiedPart part;
  part.name = "pipe at " + std::to_string(height);
  part.shape =
      Chain(RingedSurface{{from, -x, 1}, {to, x, 1}, LineSpine{from, to}, ConstantRadius{1}});
  return part;
}

const DiscPairs kUp{{0, 1}, {0, 1}, Vec3(0, 0, 1)};

TEST(CheckedClaims, leave_undecided_what_the_checker_does_not_find) {
  CheckedClaims checker;
  checker.read(pipe(0));
  const RegularClaim regular = checker.agreed({Verdict::proved, .5, {{0, 1}}, {}});
  EXPECT_EQ(regular.verdict, Verdict::proved);
  const RegularClaim gap = checker.agreed({Verdict::proved, .5, {{0, .5}}, {}});
  EXPECT_EQ(gap.verdict, Verdict::undecided);
  EXPECT_TRUE(gap.leaves.empty());
  EXPECT_EQ(gap.margin, .5);
  const EmbeddedClaim all{Verdict::proved, {{{0, 1}, {0, 1}, {}}}, {}};
  EXPECT_EQ(checker.agreed(all, regular).verdict, Verdict::proved);
  EXPECT_EQ(checker.agreed(all, gap).verdict, Verdict::undecided);
  EXPECT_TRUE(checker.agreed(MeshClaim{64, 0, {0, 1}, .01}, 0));
  EXPECT_FALSE(checker.agreed(MeshClaim{64, 0, {0, 1}, .0001}, 0));
}

TEST(CheckedClaims, weaken_a_distance_before_they_give_it_up) {
  const std::vector<CertifiedPart> parts{pipe(0), pipe(5)};
  CheckedClaims checker;
  checker.read(parts[0]);
  checker.read(parts[1]);
  const auto agreed = [&](double distance) {
    return checker.agreed(ClearanceClaim{0, 1, Verdict::proved, distance, {kUp}, {}}, parts);
  };
  EXPECT_EQ(agreed(2.5).distance, 2.5);
  EXPECT_EQ(agreed(3).distance, 3 * (1 - 0x1p-20)) << "but for rounding";
  EXPECT_EQ(agreed(5).distance, 2.5);
  const ClearanceClaim none = agreed(1e9);
  EXPECT_EQ(none.verdict, Verdict::undecided);
  EXPECT_EQ(none.distance, 0);
  EXPECT_TRUE(none.leaves.empty());
}

TEST(CheckedClaims, have_the_work_for_the_caps_of_junctions_set_aside) {
  CheckedClaims few;
  few.reserve_for({{7, {0, 1, 2, 3, 4, 5, 6}}, {9, {8, 10}}});
  CertifiedJunction many;
  many.arms.resize(700);  // of 244,650 pairs
  CheckedClaims checker;
  try {
    checker.reserve_for({many});
    FAIL() << "verify would refuse it";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
  }
}

TEST(CheckedClaims, tell_rings_that_are_off_from_rings_that_there_is_no_work_left_for) {
  CheckedClaims checker;
  checker.read(pipe(0));
  try {
    for (int i = 0; i < 100'000; ++i) {
      (void)checker.agreed(TangencyClaim{0, 0, 1e-300, 0}, 0, End::start, .1);
    }
    FAIL() << "work has an end";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
    EXPECT_EQ(error.part(), pipe(0).name);
  }
}

TEST(CheckedClaims, allow_a_curvature_for_its_last_bits_only_and_no_loose_ring) {
  CheckedClaims checker;
  checker.read(pipe(0));
  EXPECT_NO_THROW((void)checker.agreed(TangencyClaim{0, 0, 1e-300, 0}, 0, End::start, .1));
  EXPECT_THROW((void)checker.agreed(TangencyClaim{0, 0, .2, 0}, 0, End::start, .1), Error)
      << "further off than the tolerance";
}

}  // namespace
}  // namespace dupin::certification
