#include <cfenv>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "text/append_each.h"

namespace dupin::text {
namespace {

TEST(AppendEach, appends_in_order_however_many_there_are) {
  for (const std::size_t count : {0, 1, 8191, 8192, 8193, 16384, 100000}) {
    std::string expected = "begin ", text = "begin ";
    const auto append = [](std::string& end, std::size_t i) { end += std::to_string(i) + ' '; };
    for (std::size_t i = 0; i < count; ++i) {
      append(expected, i);
    }
    append_each(text, count, append);
    EXPECT_EQ(text, expected) << count;
  }
}

TEST(AppendEach, computes_alike_on_all_threads) {
  std::string text;
  std::fesetround(FE_UPWARD);
  append_each(text, 50000, [](std::string& end, std::size_t) {
    end += std::fegetround() == FE_TONEAREST ? 'n' : 'x';
  });
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(text, std::string(50000, 'n'));
}

TEST(AppendEach, throws_what_the_first_throws) {
  std::string text;
  const auto append = [](std::string& end, std::size_t i) {
    if (i % 20000 == 19999) {
      throw std::out_of_range(std::to_string(i));
    }
    end += 'x';
  };
  try {
    append_each(text, 100000, append);
    ADD_FAILURE();
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "19999");
  }
}

}  // namespace
}  // namespace dupin::text
