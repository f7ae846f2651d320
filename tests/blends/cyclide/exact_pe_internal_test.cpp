#include <cmath>

#include <gtest/gtest.h>

#include "cyclide/exact_pe.h"
#include "support/cyclide_cases.h"

namespace dupin::cyclide {
namespace {

TEST(ExactPe, products_are_those_of_the_doubles_without_rounding) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeVector a{arcs.vector(), arcs.radius(arcs.random)};
    const PeVector b{arcs.vector(), arcs.radius(arcs.random)};
    EXPECT_NEAR(product(exact(a), exact(b)).get_d(), product(a, b), 1e-13);
    const ExactPeVector d = exact(a) - exact(b);
    EXPECT_NEAR(product(d, d).get_d(), squared_tangential_distance(a, b), 1e-13);
  }
  // One part in 2^60, which doubles would lose.
  const PeVector one{Vec3(1, 0, 0), 1}, next{Vec3(std::ldexp(1, -60), 0, 0), 0};
  const ExactPeVector shifted = exact(one) - exact(next);
  EXPECT_LT(product(shifted, shifted), 0);
  EXPECT_EQ(product(exact(one), exact(one)), 0);
}

TEST(ExactPe, compares_with_a_negative_root) {
  EXPECT_TRUE(exceeds_negative_root(1, 0));
  EXPECT_TRUE(exceeds_negative_root(-1, 2));
  EXPECT_FALSE(exceeds_negative_root(-2, 2));
  EXPECT_FALSE(exceeds_negative_root(-1, 1));  // equal
  EXPECT_FALSE(exceeds_negative_root(0, 0));
  EXPECT_TRUE(exceeds_negative_root(0, 1));
  const mpq_class little(1, mpz_class(1) << 300);
  EXPECT_TRUE(exceeds_negative_root(little - 1, 1));
  EXPECT_FALSE(exceeds_negative_root(-1 - little, 1));
}

}  // namespace
}  // namespace dupin::cyclide
