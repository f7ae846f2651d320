#pragma once

#include <cmath>
#include <limits>

#include <gmpxx.h>

#include "numbers/interval.h"

namespace dupin::numbers {

[[nodiscard]] inline double below(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

[[nodiscard]] inline double above(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// n 2^exponent / d for n >= 0, d > 0.
[[nodiscard]] inline Interval quotient(const mpz_class& n, const mpz_class& d, long exponent = 0) {
  if (sgn(n) == 0) {
    return {0, 0};
  }
  // mpz_get_d_2exp truncates to a fraction in [1/2, 1): the number lies in [x, above(x)] 2^e.
  long n_exponent = 0, d_exponent = 0;
  const double x = mpz_get_d_2exp(&n_exponent, n.get_mpz_t());
  const double y = mpz_get_d_2exp(&d_exponent, d.get_mpz_t());
  const int e = static_cast<int>(n_exponent - d_exponent + exponent);
  return {std::ldexp(below(x / above(y)), e), std::ldexp(above(above(x) / y), e)};
}

}  // namespace dupin::numbers
