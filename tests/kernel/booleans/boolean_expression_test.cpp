#include "dupin/kernel/boolean_expression.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Solid box(double x0, double x1) { return Solid::from(test::box({x0, 0, 0}, {x1, 1, 1})); }

// Intervals along x: a = [0, 4], b = [3, 8], c = [1, 6], d = [2, 10].
const std::map<std::string, Solid>& operands() {
  static const std::map<std::string, Solid> solids{{"a", box(0, 4)},
                                                   {"b", box(3, 8)},
                                                   {"c", box(1, 6)},
                                                   {"d", box(2, 10)},
                                                   {"e f", box(20, 21)}};
  return solids;
}

TEST(Expression, evaluates_in_one_arrangement) {
  const struct {
    const char* text;
    int volume;
    std::size_t components;
  } rows[] = {
      {"a", 4, 1},
      {"a + b", 8, 1},
      {"a & b", 1, 1},
      {"a - b", 3, 1},
      {"a - c", 1, 1},
      {"(a + b) - c & d", 4, 2},    // [0, 8] - [2, 6]
      {"((a + b) - c) & d", 2, 1},  // ([0, 1] + [6, 8]) & [2, 10]
      {"a - b - c", 1, 1},
      {"a - (b - c)", 4, 1},
      {"a + b - c", 3, 2},
      {"a - a", 0, 0},
      {"a + \"e f\"", 5, 2},
      {"a & b & c & d", 1, 1},
      {"(a - b) + (b - a)", 7, 2},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.text);
    const Solid solid = evaluate(Expression::parse(row.text), operands());
    EXPECT_EQ(solid.exact_volume(), row.volume);
    EXPECT_EQ(solid.components(), row.components);
  }
}

TEST(Expression, prints_what_it_parses) {
  const struct {
    const char* text;
    const char* printed;
  } rows[] = {
      {"a", "a"},
      {"((a))", "a"},
      {"a+b-c&d", "a + b - c & d"},
      {"(a + b) & c", "(a + b) & c"},
      {"a - (b - c)", "a - (b - c)"},
      {"(a - b) - c", "a - b - c"},
      {"a & (b & c)", "a & (b & c)"},
      {"\"x y\" + x.y_1", "\"x y\" + x.y_1"},
  };
  for (const auto& row : rows) {
    const Expression expression = Expression::parse(row.text);
    EXPECT_EQ(expression.text(), row.printed);
    EXPECT_EQ(Expression::parse(expression.text()), expression);
  }
}

TEST(Expression, names_stand_in_order_of_first_appearance) {
  const Expression expression = Expression::parse("(c + a) & b - a");
  EXPECT_EQ(expression.names(), (std::vector<std::string>{"c", "a", "b"}));
  const Solid solid = evaluate(Expression::parse("c - a"), operands());
  for (const Source& source : solid.sources()) {
    EXPECT_LT(source.operand, 2U);
  }
}

TEST(Expression, refuses_bad_text_with_the_place) {
  const struct {
    const char* text;
    const char* where;
  } rows[] = {
      {"", "1"},   {"a +", "4"}, {"a b", "3"},     {"(a", "3"},
      {"a)", "2"}, {"& a", "1"}, {"a + \"b", "5"},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.text);
    try {
      (void)Expression::parse(row.text);
      FAIL() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed);
      EXPECT_EQ(error.where(), row.where);
    }
  }
  EXPECT_THROW((void)Expression::parse(std::string(5000, '(')), Error);
}

TEST(Expression, does_not_end_at_a_nul) {
  using std::string_literals::operator""s;
  for (const std::string& text : {"a\0"s, "a \0- b"s, "\0a"s, "a + \0"s, "(a\0)"s}) {
    EXPECT_THROW((void)Expression::parse(text), Error) << testing::PrintToString(text);
  }
}

TEST(Expression, names_whole_characters) {
  for (const auto& [text, character] :
       {std::pair("a + \u00e9", "'\u00e9'"), {"a \u20ac b", "'\u20ac'"}, {"a + %", "'%'"}}) {
    try {
      (void)Expression::parse(text);
      FAIL() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_NE(error.message().find(std::string("not ") + character), std::string::npos)
          << error.message();
    }
  }
}

TEST(Expression, refuses_operands_it_does_not_know) {
  try {
    (void)evaluate(Expression::parse("a + nothing"), operands());
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_EQ(error.part(), "nothing");
  }
}

TEST(Expression, is_asked_about_all_operands) {
  const Expression expression = Expression::parse("a + b");
  for (const std::vector<bool>& inside : {std::vector<bool>{}, {true}, {true, false, true}}) {
    EXPECT_NE(test::message_of([&] { (void)expression.contains(inside); }, Errc::invalid_argument),
              "no error");
  }
  EXPECT_TRUE(expression.contains({false, true}));
}

TEST(Expression, of_many_operands_takes_time_in_proportion) {
  constexpr int kOperands = 200000;
  std::string text = "n0";
  for (int i = 1; i < kOperands; ++i) {
    text += " - n" + std::to_string(i);
  }
  const Expression expression = Expression::parse(text);  // minutes, where each is compared to all
  EXPECT_EQ(expression.names().size(), kOperands);
  EXPECT_EQ(expression.text(), text);
}

TEST(Expression, has_no_more_parentheses_than_needed_where_they_are_nested) {
  for (const std::string text :
       {"a & (b + c)", "(a - b) & c & (d & e)", "a - (b - (c + d))", "a + b & c - d"}) {
    EXPECT_EQ(Expression::parse(text).text(), text);
  }
}

}  // namespace
}  // namespace dupin
