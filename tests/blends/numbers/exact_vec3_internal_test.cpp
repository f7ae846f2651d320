#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "numbers/exact_vec3.h"

namespace dupin::numbers {
namespace {

TEST(ExactVec3, arithmetic_rounds_nothing) {
  // In doubles 1e20 would swallow the small parts.
  const ExactVec3 a = exact(Vec3(1e20, 1, -3)), b = exact(Vec3(1, 1e-20, 2));
  EXPECT_EQ((a + b) - a, b);
  EXPECT_EQ((a - b) + b, a);
  EXPECT_EQ(mpq_class(1, 3) * (mpq_class(3) * b), b);
  EXPECT_EQ(dot(a, cross(a, b)), 0);
  EXPECT_EQ(dot(b, cross(a, b)), 0);
  // Lagrange: |a x b|^2 + (a.b)^2 = |a|^2 |b|^2.
  EXPECT_EQ(dot(cross(a, b), cross(a, b)) + dot(a, b) * dot(a, b), dot(a, a) * dot(b, b));
}

TEST(ExactVec3, of_a_double_is_the_double_itself) {
  EXPECT_EQ(exact(0.1) * 10, mpq_class("18014398509481985/18014398509481984"));
  EXPECT_EQ(exact(std::ldexp(1, -1074)).get_den(), mpz_class(1) << 1074);
}

TEST(ExactVec3, refuses_what_is_no_number) {
  for (const double x : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    try {
      (void)exact(Vec3(0, x, 0));
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace dupin::numbers
