#include <string>

#include <gtest/gtest.h>

#include "cross_check/postfix.h"

namespace dupin::cross_check {
namespace {

// What is combined at once, in brackets.
std::string combined(const std::string& text) {
  const Expression expression = Expression::parse(text);
  return evaluated<std::string>(
      expression.steps(), [&](std::uint32_t operand) { return expression.names()[operand]; },
      [](SetOperation operation, const std::vector<std::string>& sets) {
        std::string list(1, "+&-"[static_cast<int>(operation)]);
        for (const std::string& set : sets) {
          list += " " + set;
        }
        return "(" + list + ")";
      });
}

TEST(Postfix, combines_at_once_what_belongs_together) {
  EXPECT_EQ(combined("a"), "a");
  EXPECT_EQ(combined("a + b + c"), "(+ a b c)");
  EXPECT_EQ(combined("a + (b + c) + d"), "(+ a b c d)");
  EXPECT_EQ(combined("a & (b & c) & a"), "(& a b c a)");
  EXPECT_EQ(combined("a - b - c"), "(- a b c)");
  EXPECT_EQ(combined("a - (b + c) - d"), "(- a b c d)");
}

TEST(Postfix, keeps_apart_what_does_not) {
  EXPECT_EQ(combined("a - (b - c)"), "(- a (- b c))");
  EXPECT_EQ(combined("(a + b) - c"), "(- (+ a b) c)");
  EXPECT_EQ(combined("a + (b - c)"), "(+ a (- b c))");
  EXPECT_EQ(combined("a + b - c + d & e"), "(+ (- (+ a b) c) (& d e))");
  EXPECT_EQ(combined("a & (b + c) - (d & e)"), "(- (& a (+ b c)) (& d e))");
}

TEST(Postfix, of_no_steps_is_the_empty_set) {
  const auto never = [](auto&&...) -> std::string { throw Error(Errc::boolean_failed, "called"); };
  EXPECT_EQ(evaluated<std::string>({}, never, never), "");
}

}  // namespace
}  // namespace dupin::cross_check
