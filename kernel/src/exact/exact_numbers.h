#pragma once

#include <exception>
#include <new>
#include <string>

#include <CGAL/Mpzf.h>
#include <gmpxx.h>

#include "dupin/kernel/error.h"

namespace dupin::exact {

[[nodiscard]] mpq_class rational(const CGAL::Mpzf& number);

[[nodiscard]] CGAL::Mpzf integer(const mpz_class& number);

/// The double nearest to numerator / denominator (ties to even), for a positive denominator; the
/// fraction need not be in lowest terms. Infinite beyond the largest double.
[[nodiscard]] double nearest_double(const mpz_class& numerator, const mpz_class& denominator);
[[nodiscard]] double nearest_double(const mpq_class& value);

/// Runs `operation`, turning the failures of CGAL's algorithms (violated preconditions, crossing
/// constraints) into Error{boolean_failed}. `what` names the operation for the message.
template <class Operation>
auto guarded(const std::string& what, Operation&& operation) {
  try {
    return operation();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    throw Error(Errc::boolean_failed, what + " failed: " + failure.what());
  }
}

}  // namespace dupin::exact
