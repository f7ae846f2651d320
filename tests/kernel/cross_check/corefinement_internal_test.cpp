#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

#include "cross_check/corefinement.h"
#include "dupin/kernel/error.h"
#include "exact/exact_numbers.h"
#include "support/shapes.h"

namespace dupin::cross_check {
namespace {

Solid cube(const Vec3& low) { return Solid::from(test::box(low, low + Vec3::Ones())); }

template <class Operation>
std::string refusal(Operation operation) {
  try {
    (void)operation();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    return error.what();
  }
  return "not refused";
}

TEST(Corefinement, refuses_a_result_that_touches_itself_along_an_edge) {
  const Solid a = cube(Vec3::Zero()), b = cube(Vec3(1, 1, 0));
  EXPECT_EQ(refusal([&] { return corefine(SetOperation::unite, a.exact(), b.exact()); }),
            "'unite' by corefinement refuses a result that touches itself along an edge");
}

TEST(Corefinement, refuses_an_operand_that_touches_itself) {
  const Solid pair = Solid::from(test::joined(
      {test::box(Vec3::Zero(), Vec3::Ones()), test::box(Vec3::Ones(), Vec3::Constant(2))}));
  const Solid other = cube(Vec3::Constant(0.5));
  EXPECT_EQ(refusal([&] { return corefine(SetOperation::subtract, pair.exact(), other.exact()); }),
            "'subtract' by corefinement takes no operand whose surface touches itself");
}

TEST(Guarded, turns_failures_of_algorithms_into_errors) {
  EXPECT_EQ(
      refusal([] { return exact::guarded("'cut'", []() -> int { throw std::logic_error("x"); }); }),
      "'cut' failed: x");
  EXPECT_EQ(exact::guarded("'cut'", [] { return 3; }), 3);
}

TEST(Guarded, lets_errors_and_lack_of_memory_through) {
  EXPECT_THROW((void)exact::guarded("", []() -> int { throw std::bad_alloc(); }), std::bad_alloc);
  try {
    (void)exact::guarded("", []() -> int { throw Error(Errc::cancelled, "stop"); });
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

}  // namespace
}  // namespace dupin::cross_check
