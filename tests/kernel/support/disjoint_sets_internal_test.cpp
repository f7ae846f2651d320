#include <array>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "support/disjoint_sets.h"

namespace dupin::support {
namespace {

TEST(DisjointSets, are_represented_by_their_lowest_members) {
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(4, 5);
  sets.unite(0, 1);
  const std::array<std::uint32_t, 6> lowest = {0, 0, 2, 3, 3, 3};
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(sets.find(i), lowest[i]);
  }
  EXPECT_EQ(sets.representatives(), std::vector(lowest.begin(), lowest.end()));
  EXPECT_EQ(sets.count(), 3);
}

TEST(DisjointSets, take_new_members) {
  DisjointSets sets(2);
  sets.unite(0, 1);
  sets.add(2);
  EXPECT_EQ(sets.find(2), 2);
  EXPECT_EQ(sets.find(3), 3);
  sets.unite(3, 1);
  EXPECT_EQ(sets.find(3), 0);
}

TEST(DisjointSets, are_the_same_whoever_unites_them) {
  constexpr std::uint32_t kCount = 200000;
  std::mt19937 random(7);
  std::uniform_int_distribution<std::uint32_t> member(0, kCount - 1);
  // As many pairs as leave one large set and many small ones.
  std::vector<std::array<std::uint32_t, 2>> pairs(kCount);
  for (auto& pair : pairs) {
    pair = {member(random), member(random)};
  }
  DisjointSets one(kCount), many(kCount);
  for (const auto& [a, b] : pairs) {
    one.unite(a, b);
  }
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 8);
  tbb::parallel_for(std::size_t{0}, pairs.size(),
                    [&](std::size_t i) { many.unite(pairs[i][0], pairs[i][1]); });
  EXPECT_GT(one.count(), 1000);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(many.find(i), one.find(i));
  }
}

}  // namespace
}  // namespace dupin::support
