#include <gtest/gtest.h>

#include "healing/count_equations.h"

namespace dupin::healing {
namespace {

using Counts = std::vector<int>;

constexpr UnknownCount once(std::size_t size, std::int64_t majority) {
  return {size, 1, 1, majority};
}

TEST(CountEquations, the_large_go_by_their_majority_and_others_follow) {
  const std::vector<UnknownCount> unknowns{once(9, 9), once(5, -5), {1, 0, 2, 1}};
  EXPECT_EQ(solved_counts(unknowns, {{{{{0, 1}, {1, 1}, {2, 1}}}}}, false), (Counts{1, -1, 0}));
  EXPECT_EQ(solved_counts(unknowns, {{{{{0, 1}, {1, -1}, {2, 1}}}}}, false), (Counts{1, -1, -2}));
}

TEST(CountEquations, what_is_needed_in_full_is_no_choice) {
  const std::vector<UnknownCount> unknowns{once(9, 9), once(8, 8), once(2, 2), once(1, 1)};
  const std::vector<CountEquation> equations{{{{0, 1}, {1, 1}, {2, 1}, {3, 1}}}};
  EXPECT_EQ(solved_counts(unknowns, equations, false), (Counts{1, 1, -1, -1}));
  EXPECT_EQ(solved_counts(unknowns, equations, true), (Counts{1, 1, 1, 1}));
}

// Two walls between parts of which the equations know only how they differ.
TEST(CountEquations, walls_that_end_alike_are_told_apart_in_the_end) {
  const std::vector<UnknownCount> unknowns{once(9, 9), once(8, -8), once(7, 7),
                                           once(6, 6), once(2, 1),  once(2, 2)};
  const std::vector<CountEquation> equations{{{{0, 1}, {1, 1}, {4, 1}, {5, -1}}},
                                             {{{2, 1}, {3, 1}, {4, 1}, {5, -1}}}};
  EXPECT_EQ(solved_counts(unknowns, equations, false), (Counts{1, -1, 1, -1, 1, 1}));
}

}  // namespace
}  // namespace dupin::healing
