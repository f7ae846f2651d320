#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "verification/covering.h"

namespace dupin::verification {
namespace {

const ParameterInterval kTwo{0, 2};

TEST(Covering, wants_every_pair_or_those_in_order) {
  const DiscPairs low{{0, 1}, {0, 1}, {}}, mixed{{0, 1}, {1, 2}, {}}, high{{1, 2}, {1, 2}, {}};
  EXPECT_TRUE(covered(kTwo, kTwo, {low, mixed, high}, true));
  EXPECT_TRUE(covered(kTwo, kTwo, {high, mixed, low}, true));
  EXPECT_FALSE(covered(kTwo, kTwo, {low, mixed, high}, false));
  EXPECT_TRUE(covered(kTwo, kTwo, {low, mixed, high, {{1, 2}, {0, 1}, {}}}, false));
  EXPECT_FALSE(covered(kTwo, kTwo, {low, mixed}, true));
  EXPECT_FALSE(covered(kTwo, kTwo, {low, high}, true));
  EXPECT_FALSE(covered(kTwo, kTwo, {mixed, high}, true));
  EXPECT_FALSE(covered(kTwo, kTwo, {}, true));
  EXPECT_FALSE(covered(kTwo, kTwo, {}, false));
  EXPECT_TRUE(covered(kTwo, kTwo, {{{-1, 5}, {-1, 5}, {}}}, false));
}

TEST(Covering, is_not_fooled_by_gaps_of_one_bit_and_empty_leaves) {
  const double below = std::nextafter(1., 0);
  EXPECT_FALSE(covered(kTwo, {0, 1}, {{{0, below}, {0, 1}, {}}, {{1, 2}, {0, 1}, {}}}, false));
  EXPECT_FALSE(covered(kTwo, {0, 1}, {{{0, 2}, {0, below}, {}}}, false));
  EXPECT_FALSE(covered(kTwo, {0, 1}, {{{1, 1}, {0, 1}, {}}, {{2, 0}, {0, 1}, {}}}, false));
  EXPECT_FALSE(covered({0, 1}, {0, 1}, {{{0, 1}, {1, 0}, {}}, {{0, 1}, {.5, .5}, {}}}, true));
  EXPECT_FALSE(covered({0, 1}, {0, 1}, {{{.25, 1}, {0, 1}, {}}}, true)) << "the beginning";
  EXPECT_FALSE(covered({0, 1}, {0, 1}, {{{0, .75}, {0, 1}, {}}}, true)) << "the end";
}

// Leaves of a small lattice, whose cells can be looked at one by one.
TEST(Covering, agrees_with_looking_at_every_cell) {
  constexpr int kCells = 4;
  std::mt19937_64 random(3);
  const auto side = [&] {
    const int a = int(random() % kCells), b = int(random() % kCells);
    return ParameterInterval{double(std::min(a, b)), double(std::max(a, b) + 1)};
  };
  int both[2] = {0, 0};
  for (int round = 0; round < 4000; ++round) {
    std::vector<DiscPairs> leaves;
    for (std::size_t i = 1 + random() % 9; i > 0; --i) {
      leaves.push_back({side(), side(), {}});
    }
    const bool ordered = random() % 2 == 0;
    bool expected = true;
    for (int x = 0; x < kCells; ++x) {
      for (int y = ordered ? x : 0; y < kCells; ++y) {
        bool found = false;
        for (const DiscPairs& leaf : leaves) {
          found = found || (leaf.first.from <= x && x < leaf.first.to && leaf.second.from <= y &&
                            y < leaf.second.to);
        }
        expected = expected && found;
      }
    }
    ++both[expected ? 1 : 0];
    const ParameterInterval all{0, kCells};
    EXPECT_EQ(covered(all, all, leaves, ordered), expected) << round;
  }
  EXPECT_GT(both[0], 100);
  EXPECT_GT(both[1], 100);
}

}  // namespace
}  // namespace dupin::verification
