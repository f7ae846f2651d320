#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "numbers/exact_vec3.h"
#include "numbers/interval.h"

namespace dupin::numbers {

/// Exact coefficients, lowest power first; never empty.
using Polynomial = std::vector<mpq_class>;
using VectorPolynomial = std::vector<ExactVec3>;

[[nodiscard]] Polynomial product(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial square(const Polynomial& a);
[[nodiscard]] Polynomial squared_norm(const VectorPolynomial& v);
[[nodiscard]] VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b);
[[nodiscard]] VectorPolynomial derivative(const VectorPolynomial& v);

/// From Bernstein coefficients (numbers or vectors) to powers.
template <class T>
[[nodiscard]] std::vector<T> power_basis(const std::vector<T>& bernstein);

/// Bernstein coefficients on an interval, up to a positive factor that the context knows.
using Bernstein = std::vector<mpz_class>;

/// Rational numbers as integers over the least denominator that they have in common. Sums of
/// fractions take a common divisor for each term; of integers they do not.
struct OverDenominator {
  std::vector<mpz_class> numerators;
  mpz_class denominator = 1;

  OverDenominator() = default;
  explicit OverDenominator(const std::vector<mpq_class>& fractions);
  [[nodiscard]] std::vector<mpq_class> fractions() const;
};

[[nodiscard]] std::vector<mpq_class> bernstein(const Polynomial& polynomial, std::size_t degree);

/// Without leading zeros.
[[nodiscard]] Polynomial trimmed(Polynomial polynomial);
[[nodiscard]] VectorPolynomial trimmed(VectorPolynomial polynomial);

/// Both halves of the interval, each multiplied by 2^degree.
[[nodiscard]] std::pair<Bernstein, Bernstein> halves(const Bernstein& whole);

/// Each coefficient times its binomial coefficient: the form in which products are convolutions.
[[nodiscard]] Bernstein binomial_scaled(const Bernstein& b);

[[nodiscard]] mpz_class binomial(std::size_t n, std::size_t k);

/// n 2^exponent / d for n >= 0, d > 0.
[[nodiscard]] Interval quotient(const mpz_class& n, const mpz_class& d, long exponent = 0);

template <class T>
std::vector<T> power_basis(const std::vector<T>& bernstein) {
  // The j-th power's coefficient is binomial(n, j) times the j-th forward difference.
  std::vector<T> difference = bernstein, result;
  for (std::size_t j = 0; j < bernstein.size(); ++j) {
    result.push_back(T(mpq_class(binomial(bernstein.size() - 1, j)) * difference.front()));
    for (std::size_t i = 0; i + 1 < difference.size(); ++i) {
      difference[i] = difference[i + 1] - difference[i];
    }
    difference.pop_back();
  }
  return result;
}

}  // namespace dupin::numbers
