#include <gtest/gtest.h>

#include "text/drawable_text.h"

namespace dupin::text {
namespace {

TEST(DrawableText, noncharacters_are_replaced_and_nothing_else) {
  const std::string replaced = "\xEF\xBF\xBD";
  for (const char* const code : {"\xEF\xB7\x90", "\xEF\xB7\xAF", "\xEF\xBF\xBE", "\xEF\xBF\xBF",
                                 "\xF0\x9F\xBF\xBE", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(drawable(std::string("a") + code + "b"), "a" + replaced + "b");
  }
  for (const std::string text :
       {"", "pump",
        "Stra\xC3\x9F"
        "e",
        "\xE6\xB3\xB5", "\xEF\xB7\x8F", "\xEF\xB7\xB0", "\xEF\xBF\xBD", "\xF0\x9F\x98\x80"}) {
    EXPECT_EQ(drawable(text), text);
  }
  EXPECT_EQ(drawable("a\nb\xFF"), "a b" + replaced);
}

}  // namespace
}  // namespace dupin::text
