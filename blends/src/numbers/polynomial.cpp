#include "numbers/polynomial.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace dupin::numbers {

OverDenominator::OverDenominator(const std::vector<mpq_class>& fractions) {
  for (const mpq_class& x : fractions) {
    mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), x.get_den_mpz_t());
  }
  for (const mpq_class& x : fractions) {
    numerators.emplace_back(x.get_num() * (denominator / x.get_den()));
  }
}

std::vector<mpq_class> OverDenominator::fractions() const {
  std::vector<mpq_class> result;
  for (const mpz_class& x : numerators) {
    result.emplace_back(x, denominator).canonicalize();
  }
  return result;
}

namespace {

using Integers = std::vector<mpz_class>;

enum class Sign { plus, minus };

void add_product(const Integers& a, const Integers& b, Sign sign, Integers& sum) {
  sum.resize(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      (sign == Sign::plus ? mpz_addmul : mpz_submul)(sum[i + j].get_mpz_t(), a[i].get_mpz_t(),
                                                     b[j].get_mpz_t());
    }
  }
}

// The coordinates' numerators, over one denominator.
struct Coordinates {
  std::array<Integers, 3> numerators;
  mpz_class denominator;

  explicit Coordinates(const VectorPolynomial& v) {
    Polynomial all;
    for (const ExactVec3& x : v) {
      all.insert(all.end(), x.begin(), x.end());
    }
    OverDenominator over(all);
    denominator = std::move(over.denominator);
    for (std::size_t i = 0; i < over.numerators.size(); ++i) {
      numerators.at(i % 3).push_back(std::move(over.numerators[i]));
    }
  }
};

}  // namespace

Polynomial product(const Polynomial& a, const Polynomial& b) {
  const OverDenominator first(a), second(b);
  OverDenominator result;
  result.denominator = first.denominator * second.denominator;
  add_product(first.numerators, second.numerators, Sign::plus, result.numerators);
  return result.fractions();
}

Polynomial square(const Polynomial& a) { return product(a, a); }

Polynomial squared_norm(const VectorPolynomial& v) {
  const Coordinates coordinates(v);
  OverDenominator result;
  result.denominator = coordinates.denominator * coordinates.denominator;
  for (const Integers& x : coordinates.numerators) {
    add_product(x, x, Sign::plus, result.numerators);
  }
  return result.fractions();
}

VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b) {
  const Coordinates first(a), second(b);
  VectorPolynomial result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    OverDenominator across;
    across.denominator = first.denominator * second.denominator;
    add_product(first.numerators.at(j), second.numerators.at(k), Sign::plus, across.numerators);
    add_product(first.numerators.at(k), second.numerators.at(j), Sign::minus, across.numerators);
    Polynomial coordinate = across.fractions();
    for (std::size_t power = 0; power < result.size(); ++power) {
      result[power].at(i) = std::move(coordinate[power]);
    }
  }
  return result;
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

// b_i = sum of binomial(i, j) / binomial(degree, j) a_j.
std::vector<mpq_class> bernstein(const Polynomial& polynomial, std::size_t degree) {
  Polynomial scaled;
  for (std::size_t j = 0; j < polynomial.size() && j <= degree; ++j) {
    scaled.push_back(polynomial[j] / mpq_class(binomial(degree, j)));
  }
  OverDenominator result(scaled);
  // Row by row of Pascal's triangle: a_j is added to all sums below it.
  Integers powers = std::move(result.numerators);
  powers.resize(degree + 1);
  result.numerators.clear();
  for (std::size_t i = 0; i <= degree; ++i) {
    result.numerators.push_back(powers.front());
    for (std::size_t j = 0; i + j < degree; ++j) {
      powers[j] += powers[j + 1];
    }
  }
  return result.fractions();
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

Interval quotient(const mpz_class& n, const mpz_class& d, long exponent) {
  if (sgn(n) == 0) {
    return {0, 0};
  }
  // mpz_get_d_2exp truncates to a fraction in [1/2, 1): the number lies in [x, next_above(x)] 2^e.
  long n_exponent = 0, d_exponent = 0;
  const double x = mpz_get_d_2exp(&n_exponent, n.get_mpz_t());
  const double y = mpz_get_d_2exp(&d_exponent, d.get_mpz_t());
  const int e = static_cast<int>(n_exponent - d_exponent + exponent);
  // Among the subnormals, ldexp rounds once more.
  const Interval result{std::ldexp(next_below(x / next_above(y)), e),
                        std::ldexp(next_above(next_above(x) / y), e)};
  return result.lower < std::numeric_limits<double>::min() ? outward(result.lower, result.upper)
                                                           : result;
}

}  // namespace dupin::numbers
