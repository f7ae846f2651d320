#include "exact/exact_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/number_enclosure.h"

namespace dupin::exact {
namespace {

// The integer nearest to n / d, ties to even, for positive n and d.
mpz_class nearest_integer(const mpz_class& n, const mpz_class& d) {
  mpz_class quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  remainder *= 2;
  const int half = cmp(remainder, d);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) {
    ++quotient;
  }
  return quotient;
}

// floor(log2(n / d)) for positive n and d.
long binary_order(const mpz_class& n, const mpz_class& d) {
  const long guess = static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(d.get_mpz_t(), 2));
  const bool below = guess >= 0 ? n < mpz_class(d << guess) : mpz_class(n << -guess) < d;
  return below ? guess - 1 : guess;
}

}  // namespace

mpq_class rational(const CGAL::Mpzf& number) {
  mpq_class value;
  number.export_to_mpq_t(value.get_mpq_t());
  return value;
}

CGAL::Mpzf integer(const mpz_class& number) {
  // Mpzf's own conversion is right for positive numbers only.
  if (number == 0) {
    return 0;
  }
  const mpz_class size = abs(number);
  CGAL::Mpzf value;
  value.init_from_mpz_t(size.get_mpz_t());
  return number < 0 ? -std::move(value) : value;
}

Ball ball(const CGAL::Mpzf& number) {
  const double high = enclosure(number).second;
  if (!std::isfinite(high)) {
    return {0, 0, std::numeric_limits<double>::infinity()};
  }
  const auto [lower, upper] = enclosure(number - CGAL::Mpzf(high));
  return {high, upper, upper - lower};
}

Ball ball(const mpq_class& number) {
  const double high = number.get_d();  // both are rounded toward zero
  if (!std::isfinite(high)) {
    return {0, 0, std::numeric_limits<double>::infinity()};
  }
  const double low = mpq_class(number - high).get_d();
  return {high, low, std::abs(low) * 0x1p-51 + std::numeric_limits<double>::min()};
}

double nearest_double(const mpz_class& numerator, const mpz_class& denominator) {
  if (numerator == 0) {
    return 0;
  }
  const mpz_class magnitude = abs(numerator);
  // The unit in the last place has exponent -52 relative to the leading bit, and never less than
  // that of the subnormals.
  const long unit = std::max(binary_order(magnitude, denominator) - 52, -1074L);
  const mpz_class mantissa = unit >= 0
                                 ? nearest_integer(magnitude, mpz_class(denominator << unit))
                                 : nearest_integer(mpz_class(magnitude << -unit), denominator);
  const double value = std::ldexp(mantissa.get_d(), static_cast<int>(std::min(unit, 2000L)));
  return numerator < 0 ? -value : value;
}

double nearest_double(const mpq_class& value) {
  return nearest_double(value.get_num(), value.get_den());
}

double next_below(double value) {
  return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

double next_above(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity());
}

}  // namespace dupin::exact
