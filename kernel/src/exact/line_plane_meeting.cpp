#include "exact/line_plane_meeting.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <gmp.h>

#include "exact/exact_numbers.h"
#include "exact/lattice_steps.h"

namespace dupin::exact {
namespace {

/// Two's complement, the lowest digit first.
using Int256 = std::array<std::uint64_t, 4>;

constexpr int kDigitBits = 64;

Int256 difference(const Int192& x, const Int192& y) {
  const Int128 low = Int128{x.low} - Int128{y.low};
  const Int128 high = x.high - y.high + (low >> kDigitBits);
  return {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high),
          static_cast<std::uint64_t>(high >> kDigitBits),
          high < 0 ? ~std::uint64_t{0} : std::uint64_t{0}};
}

/// p x - q y. Digits below 2^64 times steps below 2^60: no sum here comes near 2^127.
Int256 difference(std::int64_t p, const Int192& x, std::int64_t q, const Int192& y) {
  const auto upper = [](Int128 value) { return value >> kDigitBits; };
  const auto lower = [](Int128 value) { return Int128{static_cast<std::uint64_t>(value)}; };
  const Int128 low = Int128{x.low} * p - Int128{y.low} * q;
  const Int128 middle = lower(x.high) * p - lower(y.high) * q + upper(low);
  const Int128 high = upper(x.high) * p - upper(y.high) * q + upper(middle);
  return {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(middle),
          static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(upper(high))};
}

bool is_negative(const Int256& value) { return value[3] >> (kDigitBits - 1) != 0; }

/// value * 2^exponent, for exponents from -900 to 900.
CGAL::Mpzf scaled(Int256 value, int exponent) {
  const bool negative = is_negative(value);
  if (negative) {
    bool carry = true;
    for (std::uint64_t& digit : value) {
      digit = ~digit + (carry ? 1 : 0);
      carry = carry && digit == 0;
    }
  }
  const int shift = exponent & (kDigitBits - 1);  // up to a whole number of digits
  std::array<mp_limb_t, 5> digits{};
  for (std::size_t i = 0; i < value.size(); ++i) {
    digits[i] |= value[i] << shift;
    digits[i + 1] = shift == 0 ? 0 : value[i] >> (kDigitBits - shift);
  }
  mpz_t integer;
  mpz_roinit_n(integer, digits.data(), digits.size());
  if (mpz_sgn(integer) == 0) {
    return 0;
  }
  CGAL::Mpzf result;
  result.init_from_mpz_t(integer);
  return result * CGAL::Mpzf(std::ldexp(negative ? -1.0 : 1.0, exponent - shift));
}

}  // namespace

std::optional<std::array<CGAL::Mpzf, 4>> lattice_meeting(const Vec3& p, const Vec3& q,
                                                         const Vec3& a, const Vec3& b,
                                                         const Vec3& c) {
  constexpr int kLargestUnit = 200;
  std::array<LatticeSteps<5>, 3> axes;
  int unit = 0;
  for (int k = 0; k < 3; ++k) {
    LatticeSteps<5>& axis = axes[static_cast<std::size_t>(k)];
    axis = lattice_steps(std::array{p[k], q[k], a[k], b[k], c[k]});
    if (!axis.are_whole || std::abs(axis.unit) > kLargestUnit) {
      return std::nullopt;
    }
    unit += axis.unit;
  }
  const auto from_a = [&axes](std::size_t i) {
    return std::array{axes[0].steps[i] - axes[0].steps[2], axes[1].steps[i] - axes[1].steps[2],
                      axes[2].steps[i] - axes[2].steps[2]};
  };
  const std::array<Int128, 3> normal = cross(from_a(3), from_a(4));
  Int192 alpha = dot(normal, from_a(0)), beta = dot(normal, from_a(1));
  Int256 weight = difference(beta, alpha);
  const bool negative = is_negative(weight);
  if (negative) {
    weight = difference(alpha, beta);
  }
  std::array<CGAL::Mpzf, 4> point;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [steps, axis_unit, are_whole] = axes[k];
    point[k] = scaled(negative ? difference(steps[1], alpha, steps[0], beta)
                               : difference(steps[0], beta, steps[1], alpha),
                      unit + axis_unit);
  }
  point[3] = scaled(weight, unit);
  return point;
}

std::array<CGAL::Mpzf, 4> line_plane_meeting(const Vec3& p, const Vec3& q, const Vec3& a,
                                             const Vec3& b, const Vec3& c) {
  if (auto point = lattice_meeting(p, q, a, b, c)) {
    return *std::move(point);
  }
  const ExactVector origin = exact_vector(a);
  const ExactVector normal = cross(exact_vector(b) - origin, exact_vector(c) - origin);
  const CGAL::Mpzf alpha = dot(normal, exact_vector(p) - origin),
                   beta = dot(normal, exact_vector(q) - origin);
  const bool negative = beta < alpha;
  const auto coordinate = [&](int k) {
    const CGAL::Mpzf from_p = CGAL::Mpzf(p[k]) * beta, from_q = CGAL::Mpzf(q[k]) * alpha;
    return negative ? from_q - from_p : from_p - from_q;
  };
  return {coordinate(0), coordinate(1), coordinate(2), negative ? alpha - beta : beta - alpha};
}

}  // namespace dupin::exact
