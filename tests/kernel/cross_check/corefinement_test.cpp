#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Solid cube(const Vec3& low) { return Solid::from(test::box(low, low + Vec3::Ones())); }

std::string refusal(SetOperation operation, const std::vector<Solid>& operands) {
  try {
    (void)combine_by(CrossCheckEngine::corefinement, operation, operands);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    return error.what();
  }
  return "not refused";
}

TEST(Corefinement, refuses_a_result_that_touches_itself_along_an_edge) {
  EXPECT_EQ(refusal(SetOperation::unite, {cube(Vec3::Zero()), cube(Vec3(1, 1, 0))}),
            "'unite' by corefinement refuses a result that touches itself along an edge");
}

TEST(Corefinement, refuses_an_operand_that_touches_itself) {
  const Solid pair = Solid::from(test::joined(
      {test::box(Vec3::Zero(), Vec3::Ones()), test::box(Vec3::Ones(), Vec3::Constant(2))}));
  EXPECT_EQ(refusal(SetOperation::subtract, {pair, cube(Vec3::Constant(0.5))}),
            "'subtract' by corefinement takes no operand whose surface touches itself");
}

TEST(Corefinement, unites_what_is_apart_without_looking_at_it) {
  const std::vector<Solid> three = {cube(Vec3::Zero()), cube(Vec3(5, 0, 0)), cube(Vec3(0.5, 0, 0))};
  const Solid united = combine_by(CrossCheckEngine::corefinement, SetOperation::unite, three);
  EXPECT_EQ(united.exact_volume(), mpq_class(5, 2));
  EXPECT_EQ(united.components(), 2U);
  ASSERT_EQ(united.sources().size(), united.triangle_count());
  EXPECT_EQ(united.sources().back(),
            (Source{0, static_cast<std::uint32_t>(united.triangle_count() - 1)}));
}

}  // namespace
}  // namespace dupin
