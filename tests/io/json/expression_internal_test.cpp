#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "json/expression.h"

namespace dupin::json {
namespace {

Json known(std::string_view name) {
  if (name == "a") {
    return 7.5;
  }
  return name == "size" ? Json("DN100") : name == "text" ? Json("x") : Json::array({1, 2});
}

Json value_of(const std::string& text, Unit unit = Unit::millimetre) {
  const Json json(text);
  const std::string source = "d.json";
  return evaluated(JsonNode(json, source, "/x"), unit, known);
}

double number_of(const std::string& text, Unit unit = Unit::millimetre) {
  return value_of(text, unit).get<double>();
}

TEST(Expression, follows_the_rules_of_arithmetic) {
  EXPECT_EQ(number_of("=1+2*3"), 7);
  EXPECT_EQ(number_of("= (1 + 2) * 3 "), 9);
  EXPECT_EQ(number_of("=7-2-1"), 4);
  EXPECT_EQ(number_of("=8/2/2"), 2);
  EXPECT_EQ(number_of("=-(2-5)"), 3);
  EXPECT_EQ(number_of("=2*-a"), -15);
  EXPECT_EQ(number_of("=.5e1 + +1"), 6);
}

TEST(Expression, may_have_white_space_of_any_kind_between_its_words) {
  EXPECT_EQ(number_of("=1+\t2"), 3);
  EXPECT_EQ(number_of("=\r\n (1 +\n\t2)\t*\r3\n"), 9);
  EXPECT_EQ(number_of("=2\tin"), 50.8);
  EXPECT_EQ(value_of("=\tlist\n"), Json::array({1, 2}));
  EXPECT_EQ(quantity("2\tin", Unit::millimetre), 50.8);
}

TEST(Expression, has_lengths_in_the_documents_unit) {
  EXPECT_EQ(number_of("=2 in"), 50.8);
  EXPECT_EQ(number_of("=1ft + 1 mm"), 305.8);
  EXPECT_EQ(number_of("=25.4 mm", Unit::inch), 1);
  EXPECT_EQ(number_of("=size"
                      "/2"),
            57.15);
  EXPECT_EQ(number_of("=size/2", Unit::centimetre), 114.3 / 10 / 2);
}

TEST(Expression, is_what_a_lone_name_stands_for) {
  EXPECT_EQ(value_of("=text"), "x");
  EXPECT_EQ(value_of("=size"), "DN100");
  EXPECT_EQ(value_of("= list "), Json::array({1, 2}));
}

TEST(Expression, is_whole_where_it_can_be) {
  EXPECT_TRUE(value_of("=12*2").is_number_unsigned());
  EXPECT_TRUE(value_of("=5/2").is_number_float());
  EXPECT_TRUE(value_of("=-3").is_number_float());
  EXPECT_TRUE(value_of("=1e300").is_number_float());
}

TEST(Expression, says_what_is_wrong_and_where) {
  const struct {
    std::string text, message;
  } rows[] = {
      {"=\t", "in \"=\t\", column 3: a number, a name or ( is missing"},
      {"=", R"x(in "=", column 2: a number, a name or ( is missing)x"},
      {"=1+", R"x(in "=1+", column 4: a number, a name or ( is missing)x"},
      {"=1 2", R"x(in "=1 2", column 4: an operator + - * / is missing)x"},
      {"=(1", R"x(in "=(1", column 4: the parenthesis of column 2 is not closed)x"},
      {"=1)", R"x(in "=1)", column 3: an operator + - * / is missing)x"},
      {"=3 km",
       R"x(in "=3 km", column 4: 'km' is no unit; mm, cm, m, in or ft may follow a number)x"},
      {"=1/(2-2)", R"x(in "=1/(2-2)", column 3: division by zero)x"},
      {"=1e999", R"x(in "=1e999", column 2: the number is out of range)x"},
      {"=1e308*10", R"x(in "=1e308*10", column 7: the result is too large)x"},
      {"=-1e308-1e308", R"x(in "=-1e308-1e308", column 8: the result is too large)x"},
      {"=text+1", R"x(in "=text+1", column 2: 'text' is neither a number nor a nominal size)x"},
      {"=1+list", R"x(in "=1+list", column 4: 'list' is neither a number nor a nominal size)x"},
      {"=.", R"x(in "=.", column 2: a number is malformed)x"},
      {"=\xc3\xa4", "in \"=\xc3\xa4\", column 2: a number, a name or ( is missing"},
  };
  for (const auto& [text, message] : rows) {
    try {
      (void)value_of(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.message(), message);
      EXPECT_EQ(error.where(), "d.json#/x");
      EXPECT_EQ(error.code(), Errc::parse_failed);
    }
  }
}

TEST(Expression, is_bounded_in_depth_and_length) {
  const auto nested = [](int depth) {
    return "=" + std::string(depth, '(') + "1" + std::string(depth, ')');
  };
  EXPECT_EQ(number_of(nested(32)), 1);
  EXPECT_THROW((void)value_of(nested(33)), Error);
  EXPECT_EQ(number_of("=" + std::string(32, '-') + "1"), 1);
  EXPECT_THROW((void)value_of("=" + std::string(33, '-') + "1"), Error);
  EXPECT_THROW((void)value_of("=" + std::string(900, '-') + "1"), Error);
  EXPECT_EQ(number_of("=1" + std::string(998, ' ')), 1);
  EXPECT_THROW((void)value_of("=1" + std::string(999, ' ')), Error);
}

TEST(Expression, stands_in_braces_in_texts) {
  const std::string source;
  const auto text = [&](const Json& json) {
    return with_braces_replaced(JsonNode(json, source, ""), Unit::millimetre, known);
  };
  EXPECT_EQ(text("n-{a*2}-{text}"), "n-15-x");
  EXPECT_EQ(text("plain"), "plain");
  EXPECT_THROW((void)text("n-{a"), Error);
  EXPECT_THROW((void)text("n-{}"), Error);
  EXPECT_THROW((void)text("n-{list}"), Error);
}

TEST(Expression, knows_what_can_be_a_name) {
  EXPECT_TRUE(is_value_name("a_1"));
  for (const char* text : {"", "1a", "a-b", "mm", "in", "a b"}) {
    EXPECT_FALSE(is_value_name(text)) << text;
  }
}

}  // namespace
}  // namespace dupin::json
