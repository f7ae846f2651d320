#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"
#include "kernel/nef_oracle.h"
#include "support/grid_solids.h"

namespace dupin {
namespace {

// `question`: a set operation or an expression.
template <class Question, class Operands>
void expect_same(const Solid& ours, const Question& question, const Operands& operands) {
  const std::optional<Solid> expected = test::by_nef(question, operands);
  ASSERT_EQ(expected.has_value(), ours.contacts().empty());
  if (expected) {
    EXPECT_EQ(ours.exact_volume(), expected->exact_volume());
    EXPECT_EQ(ours.components(), expected->components());
    EXPECT_EQ(ours.genus(), expected->genus());
  } else {
    // It may refuse to compare with what touches itself, too.
    EXPECT_NE(second_opinion(ours, CrossCheckEngine::nef, question, operands).verdict,
              CrossCheck::Verdict::disagrees);
  }
}

class RandomSolids : public testing::TestWithParam<int> {};

constexpr int kBatches = 10, kPairs = 2000, kExpressions = 200;

TEST_P(RandomSolids, in_pairs_agree_with_nef_polyhedra) {
  for (int seed = GetParam() * kPairs / kBatches; seed < (GetParam() + 1) * kPairs / kBatches;
       ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::vector<Solid> both = {test::random_grid_solid(random),
                                     test::random_grid_solid(random)};
    expect_same(unite(both), SetOperation::unite, both);
    expect_same(intersect(both), SetOperation::intersect, both);
    expect_same(subtract(both[0], {&both[1], 1}), SetOperation::subtract, both);
  }
}

// A random tree over operands named a, b, c, ...
class RandomExpression {
 public:
  RandomExpression(std::mt19937& random, std::size_t operands) : random_(random) {
    text_ = grow(0, operands);
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  static std::string name(std::size_t operand) {
    return {static_cast<char>('a' + static_cast<char>(operand))};
  }

 private:
  std::string grow(std::size_t first, std::size_t count) {
    if (count == 1) {
      return name(first);
    }
    const std::size_t left = 1 + random_() % (count - 1);
    const std::string a = grow(first, left), b = grow(first + left, count - left);
    const unsigned operation = random_() % 4;  // unions more often, lest little is left
    return "(" + a + std::string(1, "+&-+"[operation]) + b + ")";
  }

  std::mt19937& random_;
  std::string text_;
};

TEST_P(RandomSolids, in_expressions_agree_with_nef_polyhedra) {
  constexpr std::size_t kOperands = 5;
  for (int seed = GetParam() * kExpressions / kBatches;
       seed < (GetParam() + 1) * kExpressions / kBatches; ++seed) {
    std::mt19937 random(static_cast<unsigned>(10000 + seed));
    const RandomExpression expression(random, kOperands);
    SCOPED_TRACE(std::to_string(seed) + ": " + expression.text());
    std::map<std::string, Solid> operands;
    for (std::size_t i = 0; i < kOperands; ++i) {
      operands.emplace(RandomExpression::name(i), test::random_grid_solid(random));
    }
    const Expression parsed = Expression::parse(expression.text());
    expect_same(evaluate(parsed, operands), parsed, operands);
  }
}

INSTANTIATE_TEST_SUITE_P(Batches, RandomSolids, testing::Range(0, kBatches));

}  // namespace
}  // namespace dupin
