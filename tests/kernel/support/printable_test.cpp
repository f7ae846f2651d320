#include "dupin/kernel/printable.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

using namespace std::string_literals;

TEST(Printable, knows_the_length_of_control_characters) {
  for (const auto& text : {"\0x"s, "\nx"s, "\x1f"s, "\x7f"s}) {
    EXPECT_EQ(control_length(text), 1);
  }
  for (const auto* text : {"\u0080x", "\u009f"}) {
    EXPECT_EQ(control_length(text), 2);
  }
  for (const auto* text : {"\u2028x", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069"}) {
    EXPECT_EQ(control_length(text), 3);
  }
  for (const auto* text : {"", " \n", "~", "\u00a0", "\u2027", "\u202f", "\u2065", "\u206a", "\xc2",
                           "\xe2\x80", "\xe2\x82\xa8"}) {
    EXPECT_EQ(control_length(text), 0) << text;
  }
}

TEST(Printable, finds_controls_anywhere) {
  EXPECT_TRUE(has_controls("a\u202eb"));
  EXPECT_TRUE(has_controls("a\t"));
  EXPECT_FALSE(has_controls("Rohr Ä 1 \U0001F600"));
  EXPECT_FALSE(has_controls(""));
}

TEST(Printable, says_controls_and_broken_bytes_in_digits) {
  EXPECT_EQ(printable("a\tb\nc\x1b[31m\x7f \u00e9\0"s), "a\\x09b\\x0ac\\x1b[31m\\x7f \u00e9\\x00");
  EXPECT_EQ(printable("\u0085\u00a0\u202e\u202f\u2069 \xe2"),
            "\\xc2\\x85\u00a0\\xe2\\x80\\xae\u202f\\xe2\\x81\\xa9 \\xe2");
}

TEST(Printable, keeps_what_it_is_told_to) {
  EXPECT_EQ(printable("a\tb\nc\r\u0085", "\n\t"), "a\tb\nc\\x0d\\xc2\\x85");
}

}  // namespace
}  // namespace dupin
