#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "numbers/interval.h"
#include "verification/motions/jet.h"
#include "verification/work.h"

namespace dupin::verification {

/// Exact Bernstein coefficients on some stretch of the parameter; never empty.
using Polynomial = std::vector<mpq_class>;
using Curve = std::array<Polynomial, 3>;

inline mpz_class choose(std::size_t n, std::size_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return result;
}

/// Words of the longest coefficient.
inline std::size_t words(const Polynomial& p) {
  std::size_t most = 1;
  for (const mpq_class& c : p) {
    most = std::max(most, mpz_size(c.get_num_mpz_t()) + mpz_size(c.get_den_mpz_t()));
  }
  return most;
}

// Every multiplication is followed by a greatest common divisor, as dear as itself.
inline std::uint64_t work_of_part(const Polynomial& p) {
  const std::size_t n = p.size(), size = words(p);
  return n * n * n * (1 + size * size / 16) / 4 + 1;
}
inline std::uint64_t work_of_part(const std::vector<numbers::Interval>& p) {
  return p.size() * p.size() / 64 + 1;
}

/// A common denominator, and with it the coefficients times their binomial coefficients.
inline std::pair<mpz_class, std::vector<mpz_class>> binomial_numerators(const Polynomial& p) {
  mpz_class common = 1;
  for (const mpq_class& c : p) {
    common = lcm(common, c.get_den());
  }
  std::vector<mpz_class> numerators;
  for (std::size_t i = 0; i < p.size(); ++i) {
    numerators.emplace_back(choose(p.size() - 1, i) * p[i].get_num() * (common / p[i].get_den()));
  }
  return {common, std::move(numerators)};
}

inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  const std::size_t m = a.size() - 1, n = b.size() - 1;
  const std::size_t long_a = words(a), long_b = words(b);
  spend(a.size() * b.size() * (1 + long_a * long_b / 64));
  // Over the common denominators: fractions would take a common divisor for each term.
  const auto [over_a, first] = binomial_numerators(a);
  const auto [over_b, second] = binomial_numerators(b);
  std::vector<mpz_class> sum(m + n + 1);
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      sum[i + j] += first[i] * second[j];
    }
  }
  Polynomial c;
  for (std::size_t k = 0; k <= m + n; ++k) {
    c.emplace_back(sum[k], choose(m + n, k) * over_a * over_b).canonicalize();
  }
  return c;
}

/// a - b, after both have been raised to the same degree.
inline Polynomial difference(Polynomial a, Polynomial b) {
  const std::size_t size = std::max(a.size(), b.size());
  a = product(a, Polynomial(size - a.size() + 1, 1));
  b = product(b, Polynomial(size - b.size() + 1, 1));
  for (std::size_t i = 0; i < size; ++i) {
    a[i] -= b[i];
  }
  return a;
}

/// By the parameter that runs from 0 to 1 on the stretch.
inline Polynomial derivative(const Polynomial& p) {
  Polynomial d(std::max<std::size_t>(p.size() - 1, 1));
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    d[i] = mpq_class(static_cast<unsigned long>(p.size() - 1)) * (p[i + 1] - p[i]);
  }
  return d;
}

/// On the part [from, to] of the stretch [0, 1], of exact numbers or intervals: what is left of
/// `to`, and of that what is right of from / to.
template <class Number>
std::vector<Number> part(std::vector<Number> p, double from, double to) {
  spend(work_of_part(p));
  const std::size_t size = p.size();
  for (std::size_t first = 1; to < 1 && first < size; ++first) {
    for (std::size_t i = size; i-- > first;) {
      p[i] = p[i - 1] + Number(to) * (p[i] - p[i - 1]);
    }
  }
  if (from == to) {
    return std::vector<Number>(size, p.back());
  }
  const Number share = Number(from) / Number(to);
  for (std::size_t count = size; from > 0 && count > 1; --count) {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      p[i] = p[i] + share * (p[i + 1] - p[i]);
    }
  }
  return p;
}

inline Polynomial dot(const Curve& a, const Curve& b) {
  Polynomial sum = product(a[0], b[0]);
  for (std::size_t k : {1, 2}) {
    const Polynomial term = product(a[k], b[k]);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += term[i];
    }
  }
  return sum;
}

inline Curve cross(const Curve& a, const Curve& b) {
  const auto coordinate = [&](std::size_t i, std::size_t j) {
    return difference(product(a[i], b[j]), product(a[j], b[i]));
  };
  return {coordinate(1, 2), coordinate(2, 0), coordinate(0, 1)};
}

inline Curve derivative(const Curve& c) {
  return {derivative(c[0]), derivative(c[1]), derivative(c[2])};
}

[[nodiscard]] numbers::Interval enclosed(const mpq_class& value);

/// A polynomial and its derivatives, ready to be enclosed.
template <std::size_t count>
class Enclosed {
 public:
  explicit Enclosed(Polynomial p) {
    for (auto& coefficients : orders_) {
      for (const mpq_class& c : p) {
        coefficients.push_back(enclosed(c));
      }
      p = derivative(p);
    }
  }

  [[nodiscard]] Jet<count> over(double from, double to) const {
    Jet<count> result;
    for (std::size_t k = 0; k < count; ++k) {
      const auto coefficients = part(orders_[k], from, to);
      result[k] = coefficients.front();
      for (const Interval& c : coefficients) {
        result[k] = hull(result[k], c);
      }
    }
    return result;
  }

 private:
  std::array<std::vector<Interval>, count> orders_;
};

template <std::size_t count>
struct EnclosedCurve {
  explicit EnclosedCurve(const Curve& c)
      : coordinates{{Enclosed<count>(c[0]), Enclosed<count>(c[1]), Enclosed<count>(c[2])}} {}

  [[nodiscard]] JetVec<count> over(double from, double to) const {
    return {coordinates[0].over(from, to), coordinates[1].over(from, to),
            coordinates[2].over(from, to)};
  }

  std::array<Enclosed<count>, 3> coordinates;
};

/// p - weight * point
inline Polynomial about(const Polynomial& p, const Polynomial& weight, const mpq_class& point) {
  return difference(p, product(weight, {point}));
}

}  // namespace dupin::verification
