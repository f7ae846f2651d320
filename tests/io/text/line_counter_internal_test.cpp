#include <string>

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

TEST(LineCounter, counts_an_lf_behind_several_crs_once) {
  const std::string_view text = "a\r\r\nb\r\r\r\n\r\r";
  LineCounter lines(text);
  const std::size_t expected[] = {1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 4, 5};
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(lines.at(i), expected[i]) << i;
    EXPECT_EQ(LineCounter(text).at(i), expected[i]) << i;
  }
  const std::string many(1 << 20, '\r');
  EXPECT_EQ(LineCounter(many).at(many.size()), many.size() + 1);
}

}  // namespace
}  // namespace dupin::text
