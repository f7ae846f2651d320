#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"
#include "kernel/nef_oracle.h"
#include "support/grid_solids.h"

namespace dupin {
namespace {

void expect_same(const Solid& ours, const std::optional<test::NefResult>& expected) {
  ASSERT_EQ(expected.has_value(), ours.contacts().empty());
  if (expected) {
    EXPECT_EQ(ours.exact_volume(), expected->volume);
    EXPECT_EQ(ours.components(), expected->components);
    EXPECT_EQ(ours.genus(), expected->genus);
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
    using test::NefOperation;
    expect_same(unite(both), by_nef(NefOperation::unite, both[0], both[1]));
    expect_same(intersect(both), by_nef(NefOperation::intersect, both[0], both[1]));
    expect_same(subtract(both[0], {&both[1], 1}), by_nef(NefOperation::subtract, both[0], both[1]));
  }
}

// A random tree over operands named a, b, c, ..., as text and for Nef polyhedra.
class RandomExpression {
 public:
  RandomExpression(std::mt19937& random, std::size_t operands) : random_(random) {
    text_ = grow(0, operands);
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<test::NefStep>& steps() const { return steps_; }
  static std::string name(std::size_t operand) {
    return {static_cast<char>('a' + static_cast<char>(operand))};
  }

 private:
  std::string grow(std::size_t first, std::size_t count) {
    if (count == 1) {
      steps_.emplace_back(first);
      return name(first);
    }
    const std::size_t left = 1 + random_() % (count - 1);
    const std::string a = grow(first, left), b = grow(first + left, count - left);
    const unsigned operation = random_() % 4;  // unions more often, lest little is left
    steps_.emplace_back(static_cast<test::NefOperation>(operation % 3));
    return "(" + a + std::string(1, "+&-+"[operation]) + b + ")";
  }

  std::mt19937& random_;
  std::vector<test::NefStep> steps_;
  std::string text_;
};

TEST_P(RandomSolids, in_expressions_agree_with_nef_polyhedra) {
  constexpr std::size_t kOperands = 5;
  for (int seed = GetParam() * kExpressions / kBatches;
       seed < (GetParam() + 1) * kExpressions / kBatches; ++seed) {
    std::mt19937 random(static_cast<unsigned>(10000 + seed));
    const RandomExpression expression(random, kOperands);
    SCOPED_TRACE(std::to_string(seed) + ": " + expression.text());
    std::vector<Solid> operands;
    std::map<std::string, Solid> named;
    for (std::size_t i = 0; i < kOperands; ++i) {
      operands.push_back(test::random_grid_solid(random));
      named.emplace(RandomExpression::name(i), operands.back());
    }
    expect_same(evaluate(Expression::parse(expression.text()), named),
                by_nef(expression.steps(), operands));
  }
}

INSTANTIATE_TEST_SUITE_P(Batches, RandomSolids, testing::Range(0, kBatches));

}  // namespace
}  // namespace dupin
