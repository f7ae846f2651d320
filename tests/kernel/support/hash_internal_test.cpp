#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/hash.h"

namespace dupin::support {
namespace {

// How many of 4096 keys share the fullest of 4096 slots; for a perfectly random hash, about 7.
template <class Key>
long fullest_slot(const Key& key, int shift) {
  std::vector<long> slots(4096);
  for (std::uint64_t i = 0; i < slots.size(); ++i) {
    ++slots[key(i) >> shift & 4095];
  }
  return *std::max_element(slots.begin(), slots.end());
}

TEST(Hash, spreads_words_that_differ_in_few_bits_over_low_and_high_bits) {
  for (const int at : {0, 16, 32, 44, 52}) {
    for (const int shift : {0, 52}) {
      const auto one = [at](std::uint64_t i) { return mixed(0, i << at); };
      const auto first_of_two = [at](std::uint64_t i) { return mixed(mixed(0, i << at), 7); };
      const auto grid = [at](std::uint64_t i) {
        return mixed(mixed(0, (i & 63) << at), (i >> 6) << at);
      };
      EXPECT_LT(fullest_slot(one, shift), 16) << at;
      EXPECT_LT(fullest_slot(first_of_two, shift), 16) << at;
      EXPECT_LT(fullest_slot(grid, shift), 16) << at;
    }
  }
}

TEST(Hash, depends_on_the_order_of_words) {
  EXPECT_NE(mixed(mixed(0, 1), 2), mixed(mixed(0, 2), 1));
}

}  // namespace
}  // namespace dupin::support
