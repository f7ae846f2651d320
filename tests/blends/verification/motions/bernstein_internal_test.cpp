#include <random>

#include <gtest/gtest.h>

#include "numbers/interval.h"
#include "verification/motions/bernstein.h"

namespace dupin::verification {
namespace {

struct RandomPolynomials {
  std::mt19937_64 random{11};
  std::uniform_int_distribution<int> number{-9, 9};

  mpq_class rational() {
    mpq_class x(number(random), 10 + number(random));
    x.canonicalize();
    return x;
  }
  Polynomial polynomial(std::size_t size) {
    Polynomial p;
    for (std::size_t i = 0; i < size; ++i) {
      p.push_back(rational());
    }
    return p;
  }
  Curve curve(std::size_t size) { return {polynomial(size), polynomial(size), polynomial(size)}; }
};

// The sum of choose(n, i) p_i t^i (1 - t)^(n - i).
mpq_class value(const Polynomial& p, const mpq_class& t) {
  mpq_class sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    mpq_class term = choose(p.size() - 1, i) * p[i];
    for (std::size_t k = 0; k + 1 < p.size(); ++k) {
      term *= k < i ? t : mpq_class(1 - t);
    }
    sum += term;
  }
  return sum;
}

std::array<mpq_class, 3> value(const Curve& c, const mpq_class& t) {
  return {value(c[0], t), value(c[1], t), value(c[2], t)};
}

TEST(VerifierBernstein, operations_are_those_of_the_values) {
  RandomPolynomials random;
  for (std::size_t m = 1; m < 5; ++m) {
    for (std::size_t n = 1; n < 5; ++n) {
      const Polynomial a = random.polynomial(m), b = random.polynomial(n);
      const mpq_class t = random.rational();
      EXPECT_EQ(value(product(a, b), t), value(a, t) * value(b, t));
      EXPECT_EQ(product(a, b).size(), m + n - 1);
      EXPECT_EQ(value(difference(a, b), t), value(a, t) - value(b, t));
      EXPECT_EQ(difference(a, b).size(), std::max(m, n));
      const Curve u = random.curve(m), v = random.curve(n);
      const auto x = value(u, t), y = value(v, t), z = value(cross(u, v), t);
      EXPECT_EQ(value(dot(u, v), t), x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        EXPECT_EQ(z[k], x[i] * y[j] - x[j] * y[i]);
      }
    }
  }
}

TEST(VerifierBernstein, derivative_is_the_limit_of_differences) {
  RandomPolynomials random;
  const mpq_class h(1, 1 << 24);
  for (std::size_t size = 1; size < 6; ++size) {
    const Polynomial p = random.polynomial(size);
    const mpq_class t = random.rational();
    const mpq_class slope = (value(p, t + h) - value(p, t - h)) / (2 * h);
    EXPECT_LT(abs(slope - value(derivative(p), t)), mpq_class(1, 1 << 20));
  }
  EXPECT_EQ(derivative(Polynomial{5}), Polynomial{0});
}

TEST(VerifierBernstein, part_has_the_values_of_the_stretch) {
  RandomPolynomials random;
  for (std::size_t size = 1; size < 6; ++size) {
    const Polynomial p = random.polynomial(size);
    EXPECT_EQ(part(p, 0, 1), p);
    for (const auto& [from, to] :
         {std::pair(1. / 3, 7. / 9), {0., .3}, {.3, 1.}, {0., 0.}, {.6, .6}, {1., 1.}}) {
      const mpq_class a(from), b(to), t = random.rational();
      const Polynomial stretch = part(p, from, to);
      EXPECT_EQ(value(stretch, t), value(p, a + t * (b - a)));
      EXPECT_EQ(stretch.front(), value(p, a));
      EXPECT_EQ(stretch.back(), value(p, b));
    }
  }
}

TEST(VerifierBernstein, part_in_intervals_holds_the_exact_one) {
  using numbers::Interval;
  const Polynomial p{1, mpq_class(-3, 4), mpq_class(1, 8), 2};
  const std::vector<Interval> enclosed{1, -.75, .125, 2};
  for (const auto& [from, to] : {std::pair(.1, .7),
                                 {0., .3},
                                 {0., 0.},
                                 {.6, .6},
                                 {.3, 1.},
                                 {1., 1.},
                                 {0., 1.},
                                 {1e-300, 1e-290}}) {
    const auto exact = part(p, from, to);
    const auto found = part(enclosed, from, to);
    ASSERT_EQ(found.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LE(mpq_class(found[i].lower), exact[i]) << from << " " << to;
      EXPECT_GE(mpq_class(found[i].upper), exact[i]) << from << " " << to;
      EXPECT_LT(found[i].upper - found[i].lower, 1e-13) << from << " " << to;
    }
  }
}

TEST(VerifierBernstein, words_are_those_of_the_longest_coefficient) {
  const mpq_class large = mpz_class(1) << 640, small = 1 / large;  // 11 words, and 1
  EXPECT_EQ(words({1, 2}), 2U);
  EXPECT_EQ(words({1, large, 1}), 12U);
  EXPECT_EQ(words({small, 1, 1}), 12U);
  EXPECT_EQ(words({1, 1, large}), 12U);
}

TEST(VerifierBernstein, binomials_are_those_of_pascal) {
  for (std::size_t n = 1; n < 20; ++n) {
    for (std::size_t k = 1; k <= n; ++k) {
      EXPECT_EQ(choose(n, k), choose(n - 1, k - 1) + choose(n - 1, k));
    }
  }
  EXPECT_EQ(choose(5, 0), 1);
  EXPECT_EQ(choose(5, 6), 0);
}

}  // namespace
}  // namespace dupin::verification
