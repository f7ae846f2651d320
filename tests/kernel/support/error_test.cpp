#include "dupin/kernel/error.h"

#include <set>

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(Error, says_where_which_part_and_what_in_one_sentence) {
  const Error error(Errc::contact, "it touches itself", "pipe", "/parts/0");
  EXPECT_STREQ(error.what(), "/parts/0: 'pipe': it touches itself");
  EXPECT_STREQ(Error(Errc::contact, "it touches itself").what(), "it touches itself");
  EXPECT_STREQ(Error(Errc::contact, "it touches itself", "pipe").what(),
               "'pipe': it touches itself");
}

TEST(Error, takes_the_name_of_a_part_unless_it_has_one) {
  const Error nameless(Errc::not_closed, "an edge is open", "", "3");
  const Error named = nameless.in_part("bend");
  EXPECT_STREQ(named.what(), "3: 'bend': an edge is open");
  EXPECT_EQ(named.code(), Errc::not_closed);
  EXPECT_STREQ(named.in_part("tee").what(), named.what());
}

TEST(Error, has_a_name_for_every_code) {
  std::set<std::string_view> names;
  for (int code = 0; code <= static_cast<int>(Errc::internal); ++code) {
    const std::string_view text = name(static_cast<Errc>(code));
    EXPECT_NE(text, "unknown");
    EXPECT_TRUE(names.insert(text).second) << text;
  }
}

TEST(Error, has_no_control_characters) {
  using namespace std::string_literals;
  const Error error(Errc::invalid_argument, "the name 'x\0y' must be short"s, "\x1b[31mred"s,
                    "a.json#/parts/0\x7f"s);
  EXPECT_EQ(std::string(error.what()),
            "a.json#/parts/0\\x7f: '\\x1b[31mred': the name 'x\\x00y' must be short");
}

// Broken, overlong, half of a pair, and too large; and controls of two and three bytes.
TEST(Error, is_utf8) {
  const Error error(
      Errc::parse_failed,
      "read \xc8l, \xc0\xaf, \xed\xa0\x80, \xf5\x80\x80\x80 and \xc2\x9b, not \xc3\xa9, "
      "\u2026 or \U0001F600\xe2\x82, \u2028\u202e\u2069");
  EXPECT_EQ(
      std::string(error.what()),
      "read \\xc8l, \\xc0\\xaf, \\xed\\xa0\\x80, \\xf5\\x80\\x80\\x80 and \\xc2\\x9b, not "
      "\xc3\xa9, \u2026 or \U0001F600\\xe2\\x82, \\xe2\\x80\\xa8\\xe2\\x80\\xae\\xe2\\x81\\xa9");
}

}  // namespace
}  // namespace dupin
