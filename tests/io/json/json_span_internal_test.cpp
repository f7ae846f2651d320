#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "json/json_span.h"

namespace dupin::json {
namespace {

std::string at(const std::string& text, const std::vector<JsonStep>& steps) {
  const TextSpan span = json_span(text, steps);
  return text.substr(span.begin, span.end - span.begin);
}

const std::string kText =
    " {\n \"a\" : [ 1.5 , true,{} , [ ] ],\"b, ]}\\\"\": {\"c\":\"}\\\\\",\"\\u0064\": null }, "
    "\"e\":-2e3}\n";

TEST(JsonSpan, is_the_value_without_the_space_around_it) {
  using Step = JsonStep;
  const std::string key = "b, ]}\"";
  EXPECT_EQ(at(kText, {}), kText.substr(1, kText.size() - 2));
  EXPECT_EQ(at(kText, {"a"}), "[ 1.5 , true,{} , [ ] ]");
  EXPECT_EQ(at(kText, {"a", std::size_t{0}}), "1.5");
  EXPECT_EQ(at(kText, {"a", std::size_t{1}}), "true");
  EXPECT_EQ(at(kText, {"a", std::size_t{2}}), "{}");
  EXPECT_EQ(at(kText, {"a", std::size_t{3}}), "[ ]");
  EXPECT_EQ(at(kText, {Step(key), "c"}), "\"}\\\\\"") << "brackets in strings are no brackets";
  EXPECT_EQ(at(kText, {Step(key), "d"}), "null") << "a key that is written with an escape";
  EXPECT_EQ(at(kText, {"e"}), "-2e3");
}

TEST(JsonSpan, of_a_single_value_is_all_of_it) {
  EXPECT_EQ(at(" 12 ", {}), "12");
  EXPECT_EQ(at("\"a b\"", {}), "\"a b\"");
}

}  // namespace
}  // namespace dupin::json
