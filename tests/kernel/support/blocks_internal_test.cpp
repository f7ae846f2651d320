#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "support/blocks.h"

namespace dupin::support {
namespace {

// None, one block or less, and many of them with a part of one left.
constexpr std::size_t kCounts[] = {0, 1, Block::kSize, Block::kSize + 1, 20 * Block::kSize + 7};

class Blocks : public ::testing::TestWithParam<std::size_t> {
 private:
  tbb::global_control threads_{tbb::global_control::max_allowed_parallelism, 8};
};
INSTANTIATE_TEST_SUITE_P(Counts, Blocks, ::testing::ValuesIn(kCounts));

TEST_P(Blocks, hold_every_index_once) {
  std::vector<int> seen(GetParam(), 0);
  std::vector<int> numbers(block_count(GetParam()), 0);
  for_each_block(GetParam(), [&](const Block& block) {
    ++numbers[block.number];
    for (std::size_t i = block.begin; i < block.end; ++i) {
      ++seen[i];
    }
  });
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
  EXPECT_EQ(numbers, std::vector<int>(numbers.size(), 1));
}

TEST_P(Blocks, join_what_they_find_in_order) {
  const auto collect = [](std::size_t i, std::vector<std::size_t>& found) {
    found.insert(found.end(), i % 3, i);
  };
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < GetParam(); ++i) {
    collect(i, expected);
  }
  EXPECT_EQ(collect_in_order<std::size_t>(GetParam(), collect), expected);
}

TEST_P(Blocks, tell_indices_in_order) {
  const auto holds = [](std::uint32_t i) { return i % 7 < 3 || i % Block::kSize == 5; };
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < GetParam(); ++i) {
    if (holds(i)) {
      expected.push_back(i);
    }
  }
  EXPECT_EQ(indices_where(GetParam(), holds), expected);
}

TEST_P(Blocks, rank_indices_in_order) {
  const auto holds = [](std::size_t i) { return i % 7 < 3; };
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < GetParam(); ++i) {
    if (holds(i)) {
      expected.push_back(i);
    }
  }
  const Ranking ranking(GetParam(), holds);
  std::vector<std::size_t> ranked(ranking.size());
  ranking.for_each([&](std::size_t i, std::size_t rank) { ranked.at(rank) = i; });
  EXPECT_EQ(ranked, expected);
}

}  // namespace
}  // namespace dupin::support
