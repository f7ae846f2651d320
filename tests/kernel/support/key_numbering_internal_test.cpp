#include <map>
#include <random>

#include <gtest/gtest.h>

#include "support/key_numbering.h"

namespace dupin::support {
namespace {

TEST(KeyNumbering, numbers_keys_by_first_appearance) {
  KeyNumbering numbering(2);
  EXPECT_EQ(numbering.number({5, 0}), 0U);
  EXPECT_EQ(numbering.number({0, 5}), 1U);
  EXPECT_EQ(numbering.number({5, 0}), 0U);
  EXPECT_EQ(numbering.number({0, 0}), 2U);
  EXPECT_EQ(numbering.size(), 3U);
}

// Keys that differ in few bits, high or low ones, and far more of them than were expected.
TEST(KeyNumbering, agrees_with_a_map) {
  std::mt19937_64 random(3);
  for (const int shift : {0, 20, 52}) {
    KeyNumbering numbering(10);
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint32_t> known;
    for (int i = 0; i < 20000; ++i) {
      const KeyNumbering::Key key{(random() % 128) << shift, (random() % 128) << shift};
      const auto expected =
          known.emplace(std::pair(key.first, key.second), static_cast<std::uint32_t>(known.size()));
      ASSERT_EQ(numbering.number(key), expected.first->second);
    }
    EXPECT_EQ(numbering.size(), known.size());
  }
}

}  // namespace
}  // namespace dupin::support
