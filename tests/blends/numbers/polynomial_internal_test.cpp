#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "numbers/polynomial.h"

namespace dupin::numbers {
namespace {

struct RandomPolynomials {
  std::mt19937_64 random{8};
  std::uniform_int_distribution<int> number{-9, 9};

  mpq_class rational() {
    mpq_class x(number(random), 1 + number(random) * number(random) % 7 + 7);
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
  VectorPolynomial vectors(std::size_t size) {
    VectorPolynomial v;
    for (std::size_t i = 0; i < size; ++i) {
      v.push_back({rational(), rational(), rational()});
    }
    return v;
  }
};

mpq_class value(const Polynomial& p, const mpq_class& t) {
  mpq_class sum;
  for (std::size_t i = p.size(); i > 0; --i) {
    sum = sum * t + p[i - 1];
  }
  return sum;
}

ExactVec3 value(const VectorPolynomial& v, const mpq_class& t) {
  ExactVec3 sum;
  for (std::size_t i = v.size(); i > 0; --i) {
    sum = t * sum + v[i - 1];
  }
  return sum;
}

// By de Casteljau's scheme.
template <class Number>
mpq_class bernstein_value(const std::vector<Number>& b, const mpq_class& t) {
  std::vector<mpq_class> row(b.begin(), b.end());
  for (std::size_t size = row.size(); size > 1; --size) {
    for (std::size_t i = 0; i + 1 < size; ++i) {
      row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
  }
  return row.front();
}

TEST(Polynomial, products_have_the_products_of_the_values) {
  RandomPolynomials random;
  for (int i = 0; i < 40; ++i) {
    const Polynomial a = random.polynomial(1 + i % 5), b = random.polynomial(1 + i % 3);
    const VectorPolynomial v = random.vectors(1 + i % 4), w = random.vectors(1 + i % 3);
    const mpq_class t = random.rational();
    EXPECT_EQ(value(product(a, b), t), value(a, t) * value(b, t));
    EXPECT_EQ(value(square(a), t), value(a, t) * value(a, t));
    EXPECT_EQ(value(squared_norm(v), t), dot(value(v, t), value(v, t)));
    EXPECT_EQ(value(cross(v, w), t), cross(value(v, t), value(w, t)));
  }
}

TEST(Polynomial, derivatives_are_limits_of_differences) {
  RandomPolynomials random;
  for (std::size_t size = 1; size < 6; ++size) {
    const VectorPolynomial v = random.vectors(size);
    const mpq_class t = random.rational(), h(1, 1 << 20);
    const ExactVec3 difference =
        mpq_class(1 / (2 * h)) * (value(v, t + h) - value(v, t - h)) - value(derivative(v), t);
    EXPECT_LT(dot(difference, difference), mpq_class(1, 1 << 20));
  }
  EXPECT_EQ(derivative({ExactVec3{1, 2, 3}}), VectorPolynomial{ExactVec3{}});
}

TEST(Polynomial, bernstein_and_powers_lead_there_and_back) {
  RandomPolynomials random;
  for (std::size_t size = 1; size < 8; ++size) {
    const Polynomial p = random.polynomial(size);
    const auto b = bernstein(p, size - 1);
    EXPECT_EQ(power_basis(b), p);
    const auto raised = bernstein(p, size + 2);
    EXPECT_EQ(raised.size(), size + 3);
    const mpq_class t = random.rational();
    EXPECT_EQ(bernstein_value(b, t), value(p, t));
    EXPECT_EQ(bernstein_value(raised, t), value(p, t));
  }
}

TEST(Polynomial, fractions_have_one_denominator_and_the_least) {
  const OverDenominator over({mpq_class(1, 6), mpq_class(-3, 4), 2, 0});
  EXPECT_EQ(over.denominator, 12);
  EXPECT_EQ(over.numerators, (std::vector<mpz_class>{2, -9, 24, 0}));
  EXPECT_EQ(over.fractions(), (Polynomial{mpq_class(1, 6), mpq_class(-3, 4), 2, 0}));
  EXPECT_TRUE(OverDenominator().fractions().empty());
}

TEST(Polynomial, halves_have_the_values_of_their_halves) {
  RandomPolynomials random;
  for (std::size_t size = 1; size < 7; ++size) {
    Bernstein whole;
    for (std::size_t i = 0; i < size; ++i) {
      whole.emplace_back(random.number(random.random));
    }
    const auto [left, right] = halves(whole);
    const mpq_class scale(mpz_class(1) << (size - 1)), t(2, 7);
    EXPECT_EQ(bernstein_value(left, t), scale * bernstein_value(whole, t / 2));
    EXPECT_EQ(bernstein_value(right, t), scale * bernstein_value(whole, (1 + t) / 2));
    EXPECT_EQ(left.back(), right.front());
  }
}

TEST(Polynomial, scaled_coefficients_multiply_by_convolution) {
  const Bernstein a{1, -2, 3}, b{4, 5}, scaled_a = binomial_scaled(a),
                                        scaled_b = binomial_scaled(b);
  EXPECT_EQ(scaled_a, (Bernstein{1, -4, 3}));
  Bernstein convolved(4);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      convolved[i + j] += scaled_a[i] * scaled_b[j];
    }
  }
  std::vector<mpq_class> product;
  for (std::size_t k = 0; k < 4; ++k) {
    product.emplace_back(mpq_class(convolved[k]) / mpq_class(binomial(3, k)));
  }
  const mpq_class t(1, 3);
  EXPECT_EQ(bernstein_value(product, t), bernstein_value(a, t) * bernstein_value(b, t));
}

TEST(Polynomial, trimming_takes_leading_zeros_and_leaves_one) {
  EXPECT_EQ(trimmed(Polynomial{1, 0, 2, 0, 0}), (Polynomial{1, 0, 2}));
  EXPECT_EQ(trimmed(Polynomial{0, 0}), Polynomial{0});
  EXPECT_EQ(trimmed(VectorPolynomial{ExactVec3{}, ExactVec3{0, 1, 0}, ExactVec3{}}).size(), 2u);
  EXPECT_EQ(binomial(40, 20), mpz_class("137846528820"));
}

}  // namespace
}  // namespace dupin::numbers
