#include <string_view>

#include <gtest/gtest.h>

#include "text/byte_order_mark.h"

namespace dupin::text {
namespace {

TEST(ByteOrderMark, is_the_three_bytes_at_the_start) {
  EXPECT_EQ(byte_order_mark("\xEF\xBB\xBF{}"), 3U);
  EXPECT_EQ(byte_order_mark("\xEF\xBB\xBF"), 3U);
  for (const std::string_view text : {"", "\xEF\xBB", "{}", " \xEF\xBB\xBF{}"}) {
    EXPECT_EQ(byte_order_mark(text), 0U) << text;
  }
}

}  // namespace
}  // namespace dupin::text
