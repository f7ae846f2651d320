#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

TEST(TextScanner, reads_numbers_of_every_form) {
  const std::array<std::pair<std::string_view, double>, 16> forms = {
      {{"0", 0},
       {"-0", 0},
       {"-0.0", 0},
       {"7", 7},
       {"+7.5", 7.5},
       {"-7.5", -7.5},
       {"007.50", 7.5},
       {".5", 0.5},
       {"5.", 5},
       {"12.5e-1", 1.25},
       {"12.5E+1", 125},
       {"0.1", 0.1},
       {"123456789012345678901234567890", 123456789012345678901234567890.0},
       {"0.000000000000000000000000000001", 1e-30},
       {"9007199254740993", 9007199254740992},
       {"0.30000000000000004", 0.1 + 0.2}}};
  for (const auto& [text, value] : forms) {
    for (const std::string_view behind : {"", " ", "\n", "\r\n", "\t8", "#8", " 12345678"}) {
      const std::string bytes = "\t " + std::string(text) + std::string(behind);
      text::TextScanner scanner(bytes, "x", '#');
      const double found = scanner.number("a number");
      EXPECT_EQ(found, value) << bytes;
      EXPECT_FALSE(std::signbit(found) && value == 0) << bytes;
      EXPECT_EQ(scanner.position(), 2 + text.size()) << bytes;
    }
  }
}

TEST(TextScanner, refuses_what_only_begins_with_a_number) {
  for (const std::string_view text : {"7.5.", "7.5-", "7,5", "7e", "0x7", "7.5f", "--7", "+-7", "-",
                                      ".", "", "nan", "-inf", "1e999", "7\xC2\xA0"}) {
    text::TextScanner scanner(text, "x");
    EXPECT_THROW((void)scanner.number("a number"), Error) << text;
    EXPECT_EQ(scanner.position(), 0U) << text;
  }
}

TEST(TextScanner, reads_integers_within_their_limits) {
  constexpr std::int64_t kLow = -1000, kHigh = 1000000000000000000;
  const std::array<std::pair<std::string_view, std::int64_t>, 7> forms = {
      {{"0", 0},
       {"-1000", -1000},
       {"0000000000000000000000007", 7},
       {"12345678", 12345678},
       {"123456789", 123456789},
       {"999999999999999999", 999999999999999999},
       {"1000000000000000000", kHigh}}};
  for (const auto& [text, value] : forms) {
    for (const std::string_view behind : {"", " ", "\n", "#8", " 12345678"}) {
      const std::string bytes = std::string(text) + std::string(behind);
      text::TextScanner scanner(bytes, "x", '#');
      EXPECT_EQ(scanner.integer(kLow, kHigh, "a number"), value) << bytes;
      EXPECT_EQ(scanner.position(), text.size()) << bytes;
    }
  }
  for (const std::string_view text : {"-1001", "1000000000000000001", "18446744073709551617",
                                      "99999999999999999999999", "+1", "1.5", "1x", "", "x", "-"}) {
    text::TextScanner scanner(text, "x");
    EXPECT_THROW((void)scanner.integer(kLow, kHigh, "a number"), Error) << text;
  }
}

TEST(TextScanner, takes_plain_lines_of_triangles) {
  std::vector<Triangle> triangles;
  const std::string bytes = "3 0 1 2\n3 9 0 1234566\n3 1 2 3 # the end\n";
  text::TextScanner scanner(bytes, "x");
  EXPECT_TRUE(scanner.take_triangle('3', 0, 10, triangles));
  EXPECT_FALSE(scanner.take_triangle('3', 0, 1234566, triangles)) << "an index too large";
  EXPECT_EQ(scanner.position(), 8U);
  EXPECT_TRUE(scanner.take_triangle('3', 0, 1234567, triangles));
  EXPECT_FALSE(scanner.take_triangle('f', 0, 10, triangles)) << "another head";
  EXPECT_EQ(triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(triangles[1], (Triangle{9, 0, 1234566}));
  for (const std::string_view line : {"",
                                      "3",
                                      "3 ",
                                      "3 1",
                                      "3 1 1",
                                      "3 1 1 1",
                                      "3 1 1 1 ",
                                      "3 1 1 1\r\n",
                                      "3 1 1 1 1\n",
                                      "3  1 1 1\n",
                                      "3 1 1 1 \n",
                                      "3 1 1 0\n",
                                      "3 1 1 4\n",
                                      "3 1 1 -1\n",
                                      "3 1 1 4294967297\n",
                                      "3 1 1 00000001\n",
                                      "3 1 1 1.\n",
                                      "3 1 1 1/1\n",
                                      "31 1 1\n",
                                      "4 1 1 1 1\n"}) {
    text::TextScanner other(line, "x");
    std::vector<Triangle> none;
    EXPECT_FALSE(other.take_triangle('3', 1, 3, none)) << line;
    EXPECT_EQ(other.position(), 0U) << line;
    EXPECT_TRUE(none.empty()) << line;
  }
}

TEST(TextScanner, knows_where_lines_end) {
  const std::string bytes = "a # b\n\n \t\r\n\r# c\nd\v\f\n";
  text::TextScanner scanner(bytes, "x", '#');
  EXPECT_FALSE(scanner.at_line_end());
  EXPECT_TRUE(scanner.take("a"));
  EXPECT_TRUE(scanner.at_line_end());
  scanner.end_line("the end");
  EXPECT_EQ(scanner.position(), 6U);
  EXPECT_FALSE(scanner.at_end());
  EXPECT_EQ(scanner.peek(), "d");
  EXPECT_THROW(scanner.end_line("the end"), Error);
  EXPECT_EQ(scanner.token(), "d");
  EXPECT_TRUE(scanner.at_end());
  EXPECT_EQ(scanner.remaining(), 0U);
}

// Or who takes token by token never comes to the line's end.
TEST(TextScanner, takes_a_backslash_before_a_lines_end_for_a_token) {
  for (const std::string bytes : {"a\\\nb", "a \\\r\nb", "a\\ \t\nb", "a \\ \r\r\nb"}) {
    text::TextScanner scanner(bytes, "x", '#');
    EXPECT_EQ(scanner.token(), "a");
    EXPECT_FALSE(scanner.at_line_end());
    EXPECT_EQ(scanner.token(), "\\");
    EXPECT_TRUE(scanner.at_line_end());
  }
  text::TextScanner scanner("\\a\\\\b c\\", "x");
  EXPECT_EQ(scanner.token(), "\\a\\\\b");
  EXPECT_EQ(scanner.token(), "c\\");
  EXPECT_TRUE(scanner.at_end());
}

}  // namespace
}  // namespace dupin
