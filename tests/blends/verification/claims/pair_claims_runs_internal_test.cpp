// Leaves of several whole pieces, which only a plane may tell apart.
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "verification/claims/pair_claims.h"

namespace dupin::verification {
namespace {

const Vec3 kX = Vec3::UnitX(), kUp = 2 * Vec3::UnitZ();

// Four pieces of length 1 along the x axis.
CertifiedPart straight(double height) {
  const auto piece = [=](int i) {
    return test::cylinder({double(i), 0, height}, {i + 1., 0, height}, 0.25);
  };
  return test::part(piece(0), piece(1), piece(2), piece(3));
}

ClearanceClaim clearance(double distance, const std::vector<DiscPairs>& leaves) {
  return {0, 1, Verdict::proved, distance, leaves, {}};
}

TEST(ClearanceClaim, of_runs_is_the_slab_between_their_boxes) {
  const Solid low(straight(0)), high(straight(3));
  const DiscPairs all{{0, 4}, {0, 4}, kUp};
  EXPECT_TRUE(follows(low, high, {}, clearance(2.49, {all})));
  EXPECT_FALSE(follows(low, high, {}, clearance(2.51, {all})));
  EXPECT_FALSE(follows(high, low, {}, clearance(2.49, {all})));
  for (const DiscPairs& other : std::vector<DiscPairs>{{{0, 4}, {0, 4}, {}},
                                                       {{0, 4}, {0, 3}, kUp},
                                                       {{1, 4}, {0, 4}, kUp},
                                                       {{0, 5}, {0, 4}, kUp},
                                                       {{0, 4}, {-1, 4}, kUp},
                                                       {{0, 4}, {0, 4}, -kUp},
                                                       {{0, 4}, {0, 4}, Vec3::Zero()}}) {
    EXPECT_FALSE(follows(low, high, {}, clearance(1, {other})));
  }
  // In part of a piece, and in parts of two.
  EXPECT_TRUE(follows(
      low, high, {},
      clearance(2, {{{0, 4}, {0, .5}, kUp}, {{0, 4}, {.5, 1}, kUp}, {{0, 4}, {1, 4}, kUp}})));
  EXPECT_FALSE(
      follows(low, high, {}, clearance(2, {{{0, 4}, {0, 1.5}, kUp}, {{0, 4}, {1.5, 4}, kUp}})));
}

TEST(EmbeddedClaim, of_runs_needs_planes_between_them_and_short_ways_of_neighbours) {
  const Solid solid(straight(0));
  const RegularClaim regular{Verdict::proved, .5, {}, {}};
  std::vector<DiscPairs> leaves{{{0, 1}, {2, 4}, kX}, {{1, 2}, {3, 4}, kX}};
  for (double i = 0; i < 4; ++i) {
    leaves.push_back({{i, i + 1}, {i, i + 1}, {}});
    if (i < 3) {
      leaves.push_back({{i, i + 1}, {i + 1, i + 2}, {}});
    }
  }
  const EmbeddedClaim claim{Verdict::proved, leaves, {}};
  EXPECT_TRUE(follows(solid, claim, regular));
  for (const DiscPairs& other : std::vector<DiscPairs>{{{0, 2}, {2, 4}, {}},
                                                       {{0, 2}, {2, 4}, kX},
                                                       {{0, 2}, {0, 2}, {}},
                                                       {{2, 4}, {0, 1}, kX}}) {
    EmbeddedClaim more = claim;
    more.leaves.push_back(other);
    EXPECT_FALSE(follows(solid, more, regular));
  }
  EmbeddedClaim less = claim;
  less.leaves.erase(less.leaves.begin());
  EXPECT_FALSE(follows(solid, less, regular));
}

TEST(EmbeddedClaim, of_every_two_pieces_needs_a_leaf) {
  const Solid solid(straight(0));
  const RegularClaim regular{Verdict::proved, .5, {}, {}};
  EmbeddedClaim claim{Verdict::proved, {}, {}};
  for (double i = 0; i < 4; ++i) {
    for (double j = i; j < 4; ++j) {
      const DiscPairs pair{{i, i + 1}, {j, j + 1}, {}};
      claim.leaves.push_back(j < i + 2 ? pair : DiscPairs{pair.first, pair.second, kX});
    }
  }
  EXPECT_TRUE(follows(solid, claim, regular));
  for (std::size_t k = 0; k < claim.leaves.size(); ++k) {
    EmbeddedClaim less = claim;
    less.leaves.erase(less.leaves.begin() + std::ptrdiff_t(k));
    EXPECT_FALSE(follows(solid, less, regular)) << k;
  }
}

// A short way leads through a run of two pieces, too, but that is not what a leaf may say.
TEST(EmbeddedClaim, of_a_run_has_a_direction) {
  const Solid two(test::part(test::cylinder({0, 0, 0}, {1, 0, 0}, 0.25),
                             test::cylinder({1, 0, 0}, {2, 0, 0}, 0.25)));
  const RegularClaim regular{Verdict::proved, .5, {}, {}};
  const auto claim = [](std::vector<DiscPairs> leaves) {
    return EmbeddedClaim{Verdict::proved, std::move(leaves), {}};
  };
  const ParameterInterval low{0, 1}, high{1, 2}, run{0, 2};
  EXPECT_TRUE(follows(two, claim({{low, low, {}}, {low, high, {}}, {high, high, {}}}), regular));
  EXPECT_FALSE(follows(two, claim({{low, run, {}}, {high, high, {}}}), regular));
  EXPECT_FALSE(follows(two, claim({{run, high, {}}, {low, low, {}}}), regular));
  EXPECT_FALSE(follows(two, claim({{run, run, {}}}), regular));
}

TEST(Solid, has_runs_of_whole_pieces_and_boxes_of_each) {
  const Solid solid(straight(1));
  EXPECT_TRUE(solid.is_run({0, 2}));
  EXPECT_TRUE(solid.is_run({1, 4}));
  for (const ParameterInterval& t :
       std::vector<ParameterInterval>{{0, 1}, {.5, 2}, {0, 2.5}, {-1, 2}, {1, 5}, {2, 0}}) {
    EXPECT_FALSE(solid.is_run(t)) << t.from << ' ' << t.to;
  }
  EXPECT_FALSE(test::ball({0, 0, 0}, 1).is_run({0, 2}));
  ASSERT_EQ(solid.boxes().size(), 4U);
  EXPECT_TRUE(test::holds(solid.boxes()[2][0], 2));
  EXPECT_TRUE(test::holds(solid.boxes()[2][0], 3));
  EXPECT_TRUE(test::holds(solid.boxes()[2][2], 0.75));
  EXPECT_TRUE(test::holds(solid.boxes()[2][2], 1.25));
  EXPECT_FALSE(test::holds(solid.boxes()[2][2], 1.5));
}

}  // namespace
}  // namespace dupin::verification
