#include <random>

#include <Eigen/Geometry>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "numbers/quaternion.h"

namespace dupin::numbers {
namespace {

TEST(Quaternion, product_is_that_of_the_library) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int i = 0; i < 100; ++i) {
    const Quaternion<double> a{number(random), number(random), number(random), number(random)};
    const Quaternion<double> b{number(random), number(random), number(random), number(random)};
    const Eigen::Quaterniond expected =
        Eigen::Quaterniond(a[0], a[1], a[2], a[3]) * Eigen::Quaterniond(b[0], b[1], b[2], b[3]);
    const Quaternion<double> found = product(a, b);
    EXPECT_NEAR(found[0], expected.w(), 1e-14);
    EXPECT_NEAR(found[1], expected.x(), 1e-14);
    EXPECT_NEAR(found[2], expected.y(), 1e-14);
    EXPECT_NEAR(found[3], expected.z(), 1e-14);
  }
}

TEST(Quaternion, times_its_conjugate_is_its_squared_length_exactly) {
  const Quaternion<mpq_class> a{mpq_class(1, 2), mpq_class(-2, 3), 5, mpq_class(1, 7)};
  const mpq_class length = a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3];
  EXPECT_EQ(product(a, conjugate(a)), (Quaternion<mpq_class>{length, 0, 0, 0}));
  EXPECT_EQ(product(conjugate(a), a), (Quaternion<mpq_class>{length, 0, 0, 0}));
}

TEST(Quaternion, units_multiply_as_hamilton_says) {
  using Integers = Quaternion<int>;
  const Integers i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1};
  EXPECT_EQ(product(i, j), k);
  EXPECT_EQ(product(j, k), i);
  EXPECT_EQ(product(k, i), j);
  EXPECT_EQ(product(product(i, j), k), (Integers{-1, 0, 0, 0}));
}

}  // namespace
}  // namespace dupin::numbers
