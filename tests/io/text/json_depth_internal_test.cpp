#include <string>

#include <gtest/gtest.h>

#include "text/json_depth.h"

namespace dupin::text {
namespace {

std::string nested(int depth) {
  const auto count = std::size_t(depth);
  return std::string(count, '[') + std::string(count, ']');
}

TEST(JsonDepth, is_that_of_brackets_that_are_open) {
  EXPECT_EQ(first_too_deep(nested(kDeepestJson)), std::nullopt);
  EXPECT_EQ(first_too_deep(nested(kDeepestJson + 1)), std::size_t(kDeepestJson));
  std::string many;
  for (int i = 0; i < 3 * kDeepestJson; ++i) {
    many += "{\"a\": []}";
  }
  EXPECT_EQ(first_too_deep(many), std::nullopt);
  std::string mixed;
  for (int i = 0; i < kDeepestJson; ++i) {
    mixed += "{\"a\":[";
  }
  EXPECT_EQ(first_too_deep(mixed), std::size_t(6 * (kDeepestJson / 2)));
}

TEST(JsonDepth, leaves_out_what_stands_in_strings) {
  const std::string brackets(1000, '[');
  EXPECT_EQ(first_too_deep("\"" + brackets + "\""), std::nullopt);
  EXPECT_EQ(first_too_deep("\"\\\"" + brackets + "\""), std::nullopt) << "an escaped quote";
  EXPECT_EQ(first_too_deep("\"\\\\\"" + brackets), std::size_t(4 + kDeepestJson))
      << "an escaped backslash before the quote";
  EXPECT_EQ(first_too_deep("\"\\"), std::nullopt) << "cut off";
}

TEST(JsonKeys, are_counted_by_object) {
  EXPECT_FALSE(has_more_keys(R"({"a": 1, "b": {"c": 2, "d": [{"e": 3}, {"f": 4}]}})", 2));
  EXPECT_TRUE(has_more_keys(R"({"a": 1, "b": {"c": 2, "d": 5}, "e": 6})", 2));
  EXPECT_TRUE(has_more_keys(R"([{}, {"a": [], "b": {}, "c": 7}])", 2));
  EXPECT_FALSE(has_more_keys(R"({"a": ":::", ":": "\":", "b:": ":"})", 3));
  EXPECT_FALSE(has_more_keys("", 0));
  EXPECT_FALSE(has_more_keys("]]}}", 0));
  EXPECT_TRUE(has_more_keys("]]}}:", 0));
  EXPECT_TRUE(has_more_keys(nested(3 * kDeepestJson) + ":::", 2)) << "too deep, and no matter";
}

}  // namespace
}  // namespace dupin::text
