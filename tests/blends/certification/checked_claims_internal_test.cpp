#include <algorithm>

#include <gtest/gtest.h>

#include "certification/checked_claims.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"
#include "support/fillet_loops.h"

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

const WorkLeft kUsual{CertifyOptions().work, CertificateLimits::kWork};

const DiscPairs kUp{{0, 1}, {0, 1}, Vec3(0, 0, 1)};

TEST(CheckedClaims, leave_undecided_what_the_checker_does_not_find) {
  ClaimWork work(kUsual);
  const Solid solid = admitted(pipe(0), work);
  const RegularClaim regular = agreed(RegularClaim{Verdict::proved, .5, {{0, 1}}, {}}, solid, work);
  EXPECT_EQ(regular.verdict, Verdict::proved);
  const RegularClaim gap = agreed(RegularClaim{Verdict::proved, .5, {{0, .5}}, {}}, solid, work);
  EXPECT_EQ(gap.verdict, Verdict::undecided);
  EXPECT_TRUE(gap.leaves.empty());
  EXPECT_EQ(gap.margin, .5);
  const EmbeddedClaim all{Verdict::proved, {{{0, 1}, {0, 1}, {}}}, {}};
  EXPECT_EQ(agreed(all, regular, solid, work).verdict, Verdict::proved);
  EXPECT_EQ(agreed(all, gap, solid, work).verdict, Verdict::undecided);
  const MeshRooms rooms{{{0x1p-20, 4}, {1, 1}}};
  EXPECT_TRUE(agreed(MeshClaim{64, 0, {0, 1}, .01}, solid, rooms, work));
  EXPECT_FALSE(agreed(MeshClaim{64, 0, {0, 1}, .0001}, solid, rooms, work));
}

TEST(CheckedClaims, weaken_a_distance_before_they_give_it_up) {
  const std::vector<CertifiedPart> parts{pipe(0), pipe(5)};
  ClaimWork work(kUsual);
  const std::vector<Solid> solids{admitted(parts[0], work), admitted(parts[1], work)};
  const auto agreed = [&](double distance) {
    return certification::agreed(ClearanceClaim{0, 1, Verdict::proved, distance, {kUp}, {}}, parts,
                                 solids, .05, work);
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
  WorkLeft left = kUsual;
  reserve_for({{7, {0, 1, 2, 3, 4, 5, 6}}, {9, {8, 10}}}, left);
  EXPECT_LT(left.checks, kUsual.checks);
  CertifiedJunction many;
  many.arms.resize(700);  // of 244,650 pairs
  try {
    reserve_for({many}, left);
    FAIL() << "verify would refuse it";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
  }
}

TEST(CheckedClaims, bound_meshes_of_many_tightly_or_within_the_tolerance) {
  const auto shares = [](double share) {
    std::vector<double> result;
    for (const MeshRoom& room : rooms_of_many(share).all) {
      result.push_back(room.share);
    }
    return result;
  };
  const auto of_few = first_rooms().all;
  EXPECT_EQ(shares(1).size(), of_few.size()) << "what is not within is bounded as of few";
  EXPECT_EQ(shares(2).front(), of_few.front().share);
  for (const double share : {0.01, 0.5, 0.8, 0.99}) {
    const auto rooms = shares(share);
    ASSERT_EQ(rooms.size(), 3U);
    EXPECT_EQ(rooms[0], 0x1p-20);
    EXPECT_GT(rooms[1], 0x1p-20);
    EXPECT_LT(share * (1 + rooms[1]), 1) << "within the tolerance";
    EXPECT_LE(rooms[1], 0.5);
  }
}

// What there is no work left for, or what lies beyond its bounds, is not said of a fillet; that its
// balls leave their pipes is an error.
TEST(CheckedClaims, leave_undecided_how_near_a_ball_keeps) {
  const auto all = test::loops_of_all_kinds();
  const CanalFillet& loop =
      std::ranges::find_if(all, [](const auto& named) { return named.name == "cone_0"; })->loop;
  const auto far = [](const Ring& end) {
    return Ring{end.center - 99 * end.normal, -end.normal, 1, 0};
  };
  const std::array<Ring, 2> starts{far(loop.quadrics[0]), far(loop.quadrics[1])};
  std::array<Ring, 2> near = starts;
  near[1].center = loop.quadrics[1].center - 9 * near[1].normal;
  const auto agreed = [&](const ContactClaim& claim, const std::array<Ring, 2>& from,
                          std::uint64_t checks, double off = 0) {
    ClaimWork work({kUsual.searches, checks});
    LoopArcs arcs{&loop, {}};
    CanalFillet longer = loop;
    for (Ring& quadric : longer.quadrics) {
      quadric.center += 99 * quadric.normal;
      quadric.radius += 99 * quadric.slope;
    }
    arcs.loop = &longer;
    LoopClaims claims;
    claims.contact = claim;
    return certification::agreed(claims, arcs, {from, {off, off}}, .02, work).contact;
  };
  const ContactClaim right{1e-9, 1e-9};
  EXPECT_TRUE(agreed(right, starts, CertificateLimits::kWork));
  EXPECT_FALSE(agreed(right, starts, 0));
  EXPECT_FALSE(agreed({0, 1}, starts, CertificateLimits::kWork));
  EXPECT_THROW((void)agreed(right, near, CertificateLimits::kWork), Error);
  // What the pipes are off is in the claim, where it has no room for that.
  EXPECT_EQ(agreed(right, starts, CertificateLimits::kWork, 1e-10)->offset, 1e-9);
  const auto wider = agreed(right, starts, CertificateLimits::kWork, 1e-6);
  ASSERT_TRUE(wider);
  EXPECT_NEAR(wider->offset, 2e-6, 2e-9);
  EXPECT_NEAR(wider->deviation, 2e-6, 2e-9);
  EXPECT_FALSE(agreed(right, starts, CertificateLimits::kWork, .015)) << "beyond the tolerance";
}

TEST(CheckedClaims, tell_rings_that_are_off_from_rings_that_there_is_no_work_left_for) {
  ClaimWork work(kUsual);
  const Solid solid = admitted(pipe(0), work);
  try {
    for (int i = 0; i < 100'000; ++i) {
      (void)agreed(TangencyClaim{0, 0, 1e-300, 0}, {0, End::start}, .1, solid, pipe(0).name, work);
    }
    FAIL() << "work has an end";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
    EXPECT_EQ(error.part(), pipe(0).name);
  }
}

TEST(CheckedClaims, allow_a_curvature_for_its_last_bits_only_and_no_loose_ring) {
  ClaimWork work(kUsual);
  const Solid solid = admitted(pipe(0), work);
  EXPECT_NO_THROW(
      (void)agreed(TangencyClaim{0, 0, 1e-300, 0}, {0, End::start}, .1, solid, pipe(0).name, work));
  EXPECT_THROW(
      (void)agreed(TangencyClaim{0, 0, .2, 0}, {0, End::start}, .1, solid, pipe(0).name, work),
      Error)
      << "further off than the tolerance";
}

}  // namespace
}  // namespace dupin::certification
