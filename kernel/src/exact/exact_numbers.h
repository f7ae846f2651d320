#pragma once

#include <CGAL/Mpzf.h>
#include <gmpxx.h>

namespace dupin::exact {

[[nodiscard]] mpq_class rational(const CGAL::Mpzf& number);

[[nodiscard]] CGAL::Mpzf integer(const mpz_class& number);

/// The double nearest to numerator / denominator (ties to even), for a positive denominator; the
/// fraction need not be in lowest terms. Infinite beyond the largest double.
[[nodiscard]] double nearest_double(const mpz_class& numerator, const mpz_class& denominator);
[[nodiscard]] double nearest_double(const mpq_class& value);

}  // namespace dupin::exact
