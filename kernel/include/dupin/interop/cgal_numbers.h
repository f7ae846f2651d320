#pragma once

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include <CGAL/Lazy_exact_nt.h>
#include <gmpxx.h>

#include "dupin/kernel/error.h"

/// Numbers of CGAL's kernels, from and to rational ones; what cgal.h stands on.
namespace dupin::interop {

template <class Number>
struct IsLazy : std::false_type {};
template <class Exact>
struct IsLazy<CGAL::Lazy_exact_nt<Exact>> : std::true_type {};

[[noreturn]] inline void refuse(const std::string& what) {
  throw Error(Errc::invalid_argument, what);
}

/// Whether a kernel's number has a value; a lazy one that was made of a double may have none.
template <class Number>
[[nodiscard]] bool has_value(const Number& value) {
  if constexpr (std::is_floating_point_v<Number>) {
    return std::isfinite(value);
  } else if constexpr (IsLazy<Number>::value) {
    const auto& about = value.approx();
    return std::isfinite(about.inf()) || std::isfinite(about.sup()) ||
           (about.inf() < 0 && about.sup() > 0);
  } else {
    return true;
  }
}

/// The exact value of a kernel's number, which is finite.
template <class Number>
[[nodiscard]] mpq_class rational(const Number& value) {
  if (!has_value(value)) {
    refuse("a number of CGAL's is not finite");
  }
  if constexpr (std::is_floating_point_v<Number>) {
    return mpq_class(value);
  } else if constexpr (IsLazy<Number>::value) {
    return rational(value.exact());
  } else if constexpr (std::is_same_v<Number, mpq_class>) {
    return value;
  } else if constexpr (requires { value.backend().data(); }) {
    return mpq_class(value.backend().data());
  } else {
    return mpq_class(value.mpq());
  }
}

/// A kernel's number of the value given; floating-point numbers take the value toward zero.
template <class Number>
[[nodiscard]] Number number(const mpq_class& value) {
  if constexpr (std::is_floating_point_v<Number>) {
    return value.get_d();
  } else if constexpr (IsLazy<Number>::value) {
    return Number(number<typename Number::ET>(value));
  } else if constexpr (std::is_same_v<Number, mpq_class>) {
    return value;
  } else {
    return Number(value.get_mpq_t());
  }
}

template <class Point>
[[nodiscard]] std::array<mpq_class, 3> rational_coordinates(const Point& point) {
  return {rational(point.x()), rational(point.y()), rational(point.z())};
}

}  // namespace dupin::interop
