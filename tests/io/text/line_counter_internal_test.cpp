#include <gtest/gtest.h>

#include "text/line_counter.h"

namespace dupin::text {
namespace {

TEST(LineCounter, counts_ends_of_every_kind_once) {
  const std::string_view text = "a\nb\r\nc\rd\r";
  LineCounter lines(text);
  const std::size_t expected[] = {1, 1, 2, 2, 2, 3, 3, 4, 4, 5};
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(lines.at(i), expected[i]) << i;
    EXPECT_EQ(LineCounter(text).at(i), expected[i]) << i;
  }
}

}  // namespace
}  // namespace dupin::text
