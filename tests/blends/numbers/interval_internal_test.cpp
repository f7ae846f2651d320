#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "numbers/interval.h"
#include "numbers/polynomial.h"

namespace dupin::numbers {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool holds(const Interval& a, const mpq_class& x) {
  return mpq_class(a.lower) <= x && x <= mpq_class(a.upper);
}

// So many of the largest end's last bits, at most.
void expect_tight(const Interval& a, double ulps) {
  EXPECT_LE(a.upper - a.lower, ulps * std::ldexp(a.magnitude(), -52));
}

struct RandomNumbers {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> mantissa{-1, 1};
  std::uniform_int_distribution<int> exponent{-30, 30};

  double number() { return std::ldexp(mantissa(random), exponent(random)); }
  Interval interval() {
    const double a = number(), b = number();
    return {std::min(a, b), std::max(a, b)};
  }
  // Exactly, a number of the interval.
  mpq_class within(const Interval& a) {
    const mpq_class share(std::abs(mantissa(random)));
    return mpq_class(a.lower) + share * (mpq_class(a.upper) - mpq_class(a.lower));
  }
};

TEST(Interval, neighbours_of_a_double_are_those_of_the_c_library) {
  RandomNumbers numbers;
  std::vector<double> all{0.,
                          -0.,
                          kInfinity,
                          -kInfinity,
                          1,
                          -1,
                          std::ldexp(1, -1074),
                          -std::ldexp(1, -1074),
                          std::ldexp(1, -1022),
                          std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::lowest()};
  for (int i = 0; i < 1000; ++i) {
    all.push_back(numbers.number());
  }
  for (const double x : all) {
    EXPECT_EQ(next_below(x), std::nextafter(x, -kInfinity)) << x;
    EXPECT_EQ(next_above(x), std::nextafter(x, kInfinity)) << x;
  }
  EXPECT_TRUE(std::isnan(next_below(std::nan(""))));
}

TEST(Interval, results_hold_those_of_all_numbers_of_the_operands) {
  RandomNumbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const Interval a = numbers.interval(), b = numbers.interval();
    const mpq_class x = numbers.within(a), y = numbers.within(b);
    EXPECT_TRUE(holds(a + b, x + y));
    EXPECT_TRUE(holds(a - b, x - y));
    EXPECT_TRUE(holds(-a, -x));
    EXPECT_TRUE(holds(a * b, x * y));
    EXPECT_TRUE(holds(square(a), x * x));
    EXPECT_TRUE(holds(hull(a, b), x));
    EXPECT_TRUE(holds(hull(a, b), y));
    EXPECT_GE(mpq_class(a.magnitude()), abs(x));
    const Interval divisor = hull(std::abs(b.lower), std::abs(b.upper));
    const mpq_class z = numbers.within(divisor);
    EXPECT_TRUE(holds(a / divisor, x / z));
    const Interval root = sqrt(divisor);
    EXPECT_TRUE(mpq_class(root.lower) * root.lower <= z && z <= mpq_class(root.upper) * root.upper);
  }
}

TEST(Interval, results_of_numbers_are_a_few_bits_wide) {
  RandomNumbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const Interval x = numbers.number(), y = std::abs(numbers.number());
    expect_tight(x * y, 2);
    expect_tight(x / y, 2);
    expect_tight(square(x), 2);
    expect_tight(sqrt(y), 2);
  }
}

// Else they become subnormal, which takes processors a hundred times as long: curves in a plane of
// the axes took minutes.
TEST(Interval, what_is_exactly_zero_stays_so) {
  const Interval zero = 0, x(-2, 3), large(0.5, 1e300);
  for (const Interval& result : {zero + zero, zero - zero, Interval(0.3) - Interval(0.3), zero * x,
                                 x * zero, square(zero), sqrt(zero), zero / large}) {
    EXPECT_EQ(result.lower, 0);
    EXPECT_EQ(result.upper, 0);
  }
  EXPECT_EQ((zero * Interval::whole()).upper, std::numeric_limits<double>::infinity());
}

TEST(Interval, squares_and_roots_are_not_negative) {
  EXPECT_EQ(square(Interval(-1, 2)).lower, 0);
  EXPECT_EQ(square(Interval(0)).lower, 0);
  EXPECT_EQ(sqrt(Interval(-1, 4)).lower, 0);
  EXPECT_EQ(square(Interval(-3, 2)).upper, next_above(9));
}

TEST(Interval, vectors_have_products_that_hold_the_exact_ones) {
  RandomNumbers numbers;
  for (int i = 0; i < 300; ++i) {
    std::array<mpq_class, 3> x, y;
    IntervalVec a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = numbers.interval();
      b[k] = numbers.interval();
      x[k] = numbers.within(a[k]);
      y[k] = numbers.within(b[k]);
    }
    EXPECT_TRUE(holds(dot(a, b), x[0] * y[0] + x[1] * y[1] + x[2] * y[2]));
    const IntervalVec c = cross(a, b), sum = a + b, difference = a - b, twice = Interval(2) * a;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
      EXPECT_TRUE(holds(c[k], x[m] * y[n] - x[n] * y[m]));
      EXPECT_TRUE(holds(sum[k], x[k] + y[k]));
      EXPECT_TRUE(holds(difference[k], x[k] - y[k]));
      EXPECT_TRUE(holds(twice[k], 2 * x[k]));
    }
    const mpq_class squared = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    const Interval length = norm(a);
    EXPECT_TRUE(mpq_class(length.lower) * length.lower <= squared &&
                squared <= mpq_class(length.upper) * length.upper);
  }
}

// Ends of every kind: whatever reals the operands hold, results hold those of exact arithmetic.
const std::vector<double> kEnds{-kInfinity, -1.7e308, -1e160,  -3,       -1e-160, -2.3e-308,
                                -5e-324,    -0.0,     0,       5e-324,   1e-308,  1e-160,
                                1,          1e160,    1.7e308, kInfinity};

std::vector<Interval> intervals_of_every_kind() {
  std::vector<Interval> result;
  for (const double a : kEnds) {
    for (const double b : kEnds) {
      result.emplace_back(a, b);
    }
    result.emplace_back(a, std::nan(""));
    result.emplace_back(std::nan(""), a);
    result.emplace_back(a);
  }
  return result;
}

// Some reals of it, both ends among them where they are.
std::vector<mpq_class> members(const Interval& a) {
  std::vector<mpq_class> result;
  for (const double x : {a.lower, a.upper, 0.0, 1.0, -2e160, 3e-200}) {
    if (a.lower <= x && x <= a.upper && std::isfinite(x)) {
      result.emplace_back(x);
    }
  }
  return result;
}

void expect_holds(const Interval& a, const mpq_class& x) {
  EXPECT_FALSE(std::isnan(a.lower) || std::isnan(a.upper));
  EXPECT_TRUE(a.lower == -kInfinity || mpq_class(a.lower) <= x) << a.lower;
  EXPECT_TRUE(a.upper == kInfinity || x <= mpq_class(a.upper)) << a.upper;
}

TEST(Interval, without_order_or_number_is_the_whole_line) {
  for (const Interval& a : {Interval(std::nan("")), Interval(2, 1), Interval(std::nan(""), 1),
                            Interval(1, std::nan("")), Interval::whole()}) {
    EXPECT_EQ(a.lower, -kInfinity);
    EXPECT_EQ(a.upper, kInfinity);
  }
  EXPECT_EQ(Interval(kInfinity).lower, std::numeric_limits<double>::max());
  EXPECT_EQ(Interval(-kInfinity).upper, std::numeric_limits<double>::lowest());
  for (const Interval& a : intervals_of_every_kind()) {
    EXPECT_LE(a.lower, a.upper);
    EXPECT_LT(a.lower, kInfinity);
    EXPECT_GT(a.upper, -kInfinity);
  }
}

TEST(Interval, is_total_for_ends_of_every_kind) {
  const std::vector<Interval> all = intervals_of_every_kind();
  for (const Interval& a : all) {
    const std::vector<mpq_class> of_a = members(a);
    for (const mpq_class& x : of_a) {
      expect_holds(-a, -x);
      expect_holds(square(a), x * x);
      EXPECT_TRUE(a.magnitude() == kInfinity || mpq_class(a.magnitude()) >= abs(x));
      const Interval root = sqrt(a);
      EXPECT_TRUE(x < 0 || mpq_class(root.lower) * root.lower <= x);
      EXPECT_TRUE(x < 0 || root.upper == kInfinity || mpq_class(root.upper) * root.upper >= x);
    }
    for (const Interval& b : all) {
      for (const mpq_class& x : of_a) {
        for (const mpq_class& y : members(b)) {
          expect_holds(a + b, x + y);
          expect_holds(a - b, x - y);
          expect_holds(a * b, x * y);
          expect_holds(max(a, b), std::max(x, y));
          expect_holds(min(a, b), std::min(x, y));
          expect_holds(hull(a, b), x);
          expect_holds(hull(a, b), y);
          if (y != 0) {
            expect_holds(a / b, x / y);
          }
        }
      }
      const IntervalVec v{a, b, a};
      EXPECT_FALSE(std::isnan(norm(v).lower) || std::isnan(norm(v).upper));
      EXPECT_FALSE(std::isnan(dot(v, v).lower) || std::isnan(dot(v, v).upper));
    }
  }
}

TEST(Interval, quotients_and_roots_without_a_result_are_the_whole_line) {
  for (const Interval& a : {Interval(1) / Interval(0), Interval(1) / Interval(-1, 1),
                            Interval(0) / Interval(0, 1), sqrt(Interval(-2, -1))}) {
    EXPECT_EQ(a.lower, -kInfinity);
    EXPECT_EQ(a.upper, kInfinity);
  }
  EXPECT_GT((Interval(1) / Interval(0, 4)).lower, .2499) << "by all but 0";
  EXPECT_GT((Interval(1) / Interval(-0.0, 4)).lower, .2499);
  EXPECT_LT((Interval(1) / Interval(-4, 0)).upper, -.2499);
}

TEST(Quotient, among_subnormal_numbers_is_still_outward) {
  for (unsigned bits = 1060; bits < 1080; ++bits) {
    const mpz_class d = (mpz_class(1) << bits) + 12345;
    const Interval found = quotient(7, d);
    expect_holds(found, mpq_class(7, d));
  }
}

TEST(Quotient, of_integers_of_any_size_is_enclosed_tightly) {
  gmp_randclass random(gmp_randinit_default);
  random.seed(7);
  for (unsigned bits = 1; bits < 3000; bits += 37) {
    const mpz_class n = random.get_z_bits(bits), d = random.get_z_bits(3001 - bits) + 1;
    // Brought back among doubles by the exponent.
    const long exponent = long(mpz_sizeinbase(d.get_mpz_t(), 2)) - long(bits);
    mpq_class exact(n, d);
    exact.canonicalize();
    exact = exponent >= 0 ? mpq_class(exact << unsigned(exponent))
                          : mpq_class(exact >> unsigned(-exponent));
    const Interval found = quotient(n, d, exponent);
    EXPECT_TRUE(holds(found, exact)) << bits;
    expect_tight(found, 8);
  }
  EXPECT_EQ(quotient(0, 5, 100).upper, 0);
}

}  // namespace
}  // namespace dupin::numbers
