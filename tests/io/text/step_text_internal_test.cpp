#include <gtest/gtest.h>

#include "text/step_text.h"

namespace dupin::text {
namespace {

// As a library would, that breaks lines wherever they are full.
std::string broken(const std::string& text, std::size_t width) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += i > 0 && i % width == 0 ? "\n" : "";
    result += text[i];
  }
  return result;
}

TEST(StepText, writes_names_as_the_standard_asks_for) {
  for (const auto& [name, expected] : std::vector<std::pair<std::string, std::string>>{
           {"pipe 1", "pipe 1"},
           {"it's", "it\\X2\\0027\\X0\\s"},
           {"a\\b~", "a\\X2\\005C\\X0\\b\\X2\\007E\\X0\\"},
           {"\u00e4", "\\X2\\00E4\\X0\\"},
           {"\u65e5", "\\X2\\65E5\\X0\\"},
           {"\U0001F600", "\\X4\\0001F600\\X0\\"},
           {"a\nb", "a\\X2\\FFFD\\X0\\b"},
           {"\x80", "\\X2\\FFFD\\X0\\"},
           {"", ""}}) {
    EXPECT_EQ(with_step_strings(step_token(name)), expected) << name;
  }
}

TEST(StepText, keeps_names_whole_where_lines_are_broken) {
  const std::string token = step_token("\u65e5\u672c'\U0001F600\u8a9e");
  for (std::size_t width = 1; width < 12; ++width) {
    std::string text = with_step_strings(broken(token, width));
    std::erase(text, '\n');
    EXPECT_EQ(text, with_step_strings(token)) << width;
    // None within a character.
    const std::string whole = with_step_strings(broken(token, width));
    for (std::size_t at = whole.find("\\X2\\"); at != std::string::npos;
         at = whole.find("\\X2\\", at + 1)) {
      EXPECT_EQ(whole.substr(at, 12).find('\n'), std::string::npos) << width;
    }
  }
}

TEST(StepText, takes_only_well_formed_utf_8) {
  for (const char* bad : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5",
                          "\xE6\x97", "\xFF"}) {
    EXPECT_EQ(code_point(bad).value, 0xFFFDU) << bad;
    EXPECT_EQ(code_point(bad).length, 1U);
  }
  EXPECT_EQ(printable(std::string("a\0b\x7F", 4)), "a\uFFFDb\uFFFD");
  EXPECT_EQ(ascii_only("\u00e4\nb"), "__b");
}

}  // namespace
}  // namespace dupin::text
