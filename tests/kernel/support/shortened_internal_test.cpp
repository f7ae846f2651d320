#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/shortened.h"

namespace dupin::support {
namespace {

const std::string kLong(10'000, 'n'), kShown = std::string(60, 'n') + "\u2026";

TEST(Shortened, keeps_what_fits_and_whole_characters) {
  EXPECT_EQ(shortened(""), "");
  EXPECT_EQ(shortened(std::string(60, 'x')), std::string(60, 'x'));
  EXPECT_EQ(shortened(kLong), kShown);
  EXPECT_EQ(shortened(kShown), kShown);
  EXPECT_EQ(shortened(std::string(59, 'x') + "\u00e4" + kLong), std::string(59, 'x') + "\u2026");
}

TEST(Shortened, quotes_and_words_in_messages_are_shortened) {
  const struct {
    std::string message, shown;
  } table[]{
      {"the part's end is not that of 'a'", "the part's end is not that of 'a'"},
      {"there is no '" + kLong + "' here", "there is no '" + kShown + "' here"},
      {"not \"" + kLong + "\"; nor '" + kLong + "'.",
       "not \"" + kShown + "\"; nor '" + kShown + "'."},
      {"in \"a + " + kLong + " b's\": no", "in \"a + " + std::string(56, 'n') + "\u2026\": no"},
      {"--format: " + kLong + " is none", "--format: " + kShown + " is none"},
      {"read '" + kLong, "read '" + std::string(59, 'n') + "\u2026"},
      {"cannot read /" + kLong + "/x: no", "cannot read /" + kLong + "/x: no"},
      {"two  blanks\nand a line ", "two  blanks\nand a line "},
  };
  for (const auto& [message, shown] : table) {
    EXPECT_EQ(with_short_quotes(message), shown);
    EXPECT_EQ(with_short_quotes(shown), shown);
  }
}

TEST(Shortened, places_keep_their_files) {
  EXPECT_EQ(with_short_keys(kLong + ".json"), kLong + ".json");
  EXPECT_EQ(with_short_keys(kLong + ".json#/parts/0/" + kLong + "/x"),
            kLong + ".json#/parts/0/" + std::string(59, 'n') + "\u2026/x");
}

TEST(Shortened, errors_keep_the_names_that_programs_compare) {
  const Error error(Errc::invalid_argument, "not '" + kLong + "'", kLong, "d.json#/" + kLong);
  EXPECT_EQ(error.part(), kLong);
  EXPECT_EQ(error.where(), "d.json#/" + kLong);
  EXPECT_EQ(error.message(), "not '" + kShown + "'");
  EXPECT_LT(std::string(error.what()).size(), 250U);
}

}  // namespace
}  // namespace dupin::support
