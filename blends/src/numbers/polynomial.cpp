#include "numbers/polynomial.h"

namespace dupin::numbers {

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      c[i + j] += a[i] * b[j];
    }
  }
  return c;
}

Polynomial square(const Polynomial& a) { return product(a, a); }

Polynomial squared_norm(const VectorPolynomial& v) {
  Polynomial c(2 * v.size() - 1);
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) {
      c[i + j] += dot(v[i], v[j]);
    }
  }
  return c;
}

VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b) {
  VectorPolynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      c[i + j] = c[i + j] + cross(a[i], b[j]);
    }
  }
  return c;
}

VectorPolynomial derivative(const VectorPolynomial& v) {
  VectorPolynomial c;
  for (std::size_t i = 1; i < v.size(); ++i) {
    c.push_back(mpq_class(static_cast<unsigned long>(i)) * v[i]);
  }
  return c.empty() ? VectorPolynomial{ExactVec3{}} : c;
}

Polynomial trimmed(Polynomial polynomial) {
  while (polynomial.size() > 1 && polynomial.back() == 0) {
    polynomial.pop_back();
  }
  return polynomial;
}

VectorPolynomial trimmed(VectorPolynomial polynomial) {
  while (polynomial.size() > 1 && polynomial.back() == ExactVec3{}) {
    polynomial.pop_back();
  }
  return polynomial;
}

mpz_class binomial(std::size_t n, std::size_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return result;
}

std::vector<mpq_class> bernstein(const Polynomial& polynomial, std::size_t degree) {
  std::vector<mpq_class> result(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    for (std::size_t j = 0; j < polynomial.size() && j <= i; ++j) {
      result[i] += polynomial[j] * mpq_class(binomial(i, j)) / mpq_class(binomial(degree, j));
    }
  }
  return result;
}

std::pair<Bernstein, Bernstein> halves(const Bernstein& whole) {
  const std::size_t degree = whole.size() - 1;
  Bernstein row = whole, left(whole.size()), right(whole.size());
  for (std::size_t r = 0; r <= degree; ++r) {
    left[r] = row.front() << (degree - r);
    right[degree - r] = row[degree - r] << (degree - r);
    for (std::size_t i = 0; i + r < degree; ++i) {
      row[i] += row[i + 1];
    }
  }
  return {std::move(left), std::move(right)};
}

Bernstein binomial_scaled(const Bernstein& b) {
  Bernstein scaled(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    scaled[i] = b[i] * binomial(b.size() - 1, i);
  }
  return scaled;
}

}  // namespace dupin::numbers
