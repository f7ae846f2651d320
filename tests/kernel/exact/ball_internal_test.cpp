#include <cmath>
#include <limits>
#include <random>

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "exact/ball.h"

namespace dupin::exact {
namespace {

class Balls : public testing::Test {
 protected:
  double value(double size) {
    return std::ldexp(std::uniform_real_distribution<double>(-size, size)(random_),
                      std::uniform_int_distribution<int>(-60, 60)(random_));
  }
  std::mt19937_64 random_{5};
  CGAL::Protect_FPU_rounding<true> rounding_;
};

bool encloses(const Ball& ball, const mpq_class& exact) {
  const mpq_class off = exact - mpq_class(ball.high()) - mpq_class(ball.low());
  return abs(off) <= mpq_class(ball.radius());
}

// What is known of a number, and it.
struct Known {
  Ball ball;
  mpq_class exact;
};

Known sum(const Known& a, const Known& b) { return {a.ball + b.ball, a.exact + b.exact}; }
Known difference(const Known& a, const Known& b) { return {a.ball - b.ball, a.exact - b.exact}; }
Known product(const Known& a, const Known& b) { return {a.ball * b.ball, a.exact * b.exact}; }

// Sums of products and their quotients, as points and determinants are made of.
TEST_F(Balls, enclose_what_they_stand_for) {
  const auto given = [&] {
    const double x = value(1);
    return Known{x, x};
  };
  for (int round = 0; round < 20000; ++round) {
    const Known a = given(), b = given(), c = given(), d = given();
    const Known top = difference(product(a, b), product(c, d));
    const Known bottom = sum(product(sum(a, c), d), product(b, c));
    ASSERT_TRUE(encloses(top.ball, top.exact)) << round;
    ASSERT_TRUE(encloses(bottom.ball, bottom.exact)) << round;
    if (bottom.exact != 0) {
      const Known quotient{top.ball / bottom.ball, top.exact / bottom.exact};
      ASSERT_TRUE(encloses(quotient.ball, quotient.exact)) << round;
      const Known again = difference(product(quotient, bottom), top);
      ASSERT_TRUE(encloses(again.ball, again.exact)) << round;
    }
  }
}

// Ends of numbers that all but cancel: a double of them has no digit that is right.
TEST_F(Balls, keep_a_hundred_bits) {
  for (int round = 0; round < 2000; ++round) {
    const double a = 1 + std::abs(value(0x1p-60)), b = 3, c = std::nextafter(a, 2);
    const Ball third = Ball(a) / Ball(b), other = Ball(c) / Ball(b);
    EXPECT_LE(third.radius(), 0x1p-98);
    EXPECT_EQ((other - third).sign(), 1);
    EXPECT_EQ((third - other).sign(), -1);
    EXPECT_EQ((third - third).sign(), 0);
    const mpq_class exact = (mpq_class(c) - mpq_class(a)) / 3;
    EXPECT_TRUE(encloses(other - third, exact));
    EXPECT_GT((other - third).infimum(), 0);
    EXPECT_LE(mpq_class((other - third).infimum()), exact);
    EXPECT_GE(mpq_class((other - third).supremum()), exact);
  }
}

TEST_F(Balls, have_a_sign_only_where_it_is_certain) {
  EXPECT_EQ(Ball(0).sign(), 0);
  EXPECT_EQ(Ball(0x1p-1074).sign(), 1);
  EXPECT_EQ(Ball(1, -0x1p-80, 0x1p-70).sign(), 1);
  EXPECT_EQ(Ball(0x1p-75, 0, 0x1p-70).sign(), 0);
  EXPECT_EQ(Ball(-1, 0, 2).sign(), 0);
  const double large = 0x1p1000, infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ((Ball(large) * Ball(large) - Ball(large)).sign(), 0);
  EXPECT_EQ((Ball(large) * Ball(-large)).sign(), 0);
  EXPECT_EQ((Ball(large) * Ball(-large) + Ball(large) * Ball(large)).sign(), 0);
  EXPECT_EQ((Ball(-0x1p1023) - Ball(0x1p1023)).sign(), 0);
  EXPECT_EQ((Ball(-large) / Ball(0x1p-100)).sign(), 0);
  EXPECT_EQ((Ball(infinite) - Ball(infinite)).sign(), 0);
  EXPECT_EQ((Ball(1) / Ball(0)).sign(), 0);
  EXPECT_EQ((Ball(1) / Ball(0x1p-70, 0, 0x1p-60)).sign(), 0);
  EXPECT_EQ((Ball(1) / (Ball(1) - Ball(1))).sign(), 0);
}

// Products of what is left of products, below the smallest double.
TEST_F(Balls, enclose_what_underflows) {
  for (int round = 0; round < 2000; ++round) {
    const double a = std::ldexp(value(1), -500), b = std::ldexp(value(1), -520);
    EXPECT_TRUE(encloses(Ball(a) * Ball(b), mpq_class(a) * mpq_class(b)));
    const double tiny = std::ldexp(value(1), -1040);
    EXPECT_TRUE(encloses(Ball(tiny) * Ball(0.3), mpq_class(tiny) * mpq_class(0.3)));
    EXPECT_TRUE(encloses(Ball(tiny) + Ball(a), mpq_class(tiny) + mpq_class(a)));
  }
}

}  // namespace
}  // namespace dupin::exact
