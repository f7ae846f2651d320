#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/sequences.h"

namespace dupin::support {
namespace {

TEST(Sequences, are_sorted_without_repetition) {
  std::vector<int> items{3, 1, 3, 2, 1};
  sort_unique(items);
  EXPECT_EQ(items, (std::vector<int>{1, 2, 3}));
}

TEST(Sequences, of_numbers_begin_with_0) {
  EXPECT_EQ(numbers_below(3), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(numbers_below(0).empty());
}

TEST(Sequences, are_selected_in_the_order_of_places) {
  const std::vector<std::string> items{"a", "b", "c"};
  const std::vector<std::uint32_t> places{2, 0, 2};
  EXPECT_EQ(selected(std::span(items), std::span(places)),
            (std::vector<std::string>{"c", "a", "c"}));
}

}  // namespace
}  // namespace dupin::support
