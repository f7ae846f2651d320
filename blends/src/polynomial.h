#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "exact_spine.h"

namespace dupin::detail {

/// Exact coefficients, lowest power first; never empty.
using Polynomial = std::vector<mpq_class>;
using VectorPolynomial = std::vector<ExactVec3>;

[[nodiscard]] Polynomial product(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial square(const Polynomial& a);
[[nodiscard]] Polynomial squared_norm(const VectorPolynomial& v);
[[nodiscard]] VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b);
[[nodiscard]] VectorPolynomial derivative(const VectorPolynomial& v);

/// Bernstein coefficients on an interval, up to a positive factor that the context knows.
using Bernstein = std::vector<mpz_class>;

[[nodiscard]] std::vector<mpq_class> bernstein(const Polynomial& polynomial, std::size_t degree);

/// Both halves of the interval, each multiplied by 2^degree.
[[nodiscard]] std::pair<Bernstein, Bernstein> halves(const Bernstein& whole);

/// Each coefficient times its binomial coefficient: the form in which products are convolutions.
[[nodiscard]] Bernstein binomial_scaled(const Bernstein& b);

[[nodiscard]] mpz_class binomial(std::size_t n, std::size_t k);

}  // namespace dupin::detail
