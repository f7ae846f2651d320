#include "dupin/kernel/enclosure.h"

#include <cmath>
#include <limits>

#include <mpfr.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// Twice the 53 bits of a double and more: the square of a double, and so its root, is held exactly.
// Everything wider is rounded in the direction asked for at every step.
constexpr mpfr_prec_t kPrecision = 256;

/// A number that is rounded in one direction throughout.
class Directed {
 public:
  Directed(const mpq_class& value, mpfr_rnd_t rounding) : rounding_(rounding) {
    mpfr_init2(number_, kPrecision);
    mpfr_set_q(number_, value.get_mpq_t(), rounding_);
  }
  Directed(const Directed&) = delete;
  Directed& operator=(const Directed&) = delete;
  ~Directed() { mpfr_clear(number_); }

  Directed& square_root() {
    mpfr_sqrt(number_, number_, rounding_);
    return *this;
  }
  /// The angle of the point (x, number).
  [[nodiscard]] double angle_above(const Directed& x, mpfr_rnd_t rounding) {
    mpfr_atan2(number_, number_, x.number_, rounding);
    return mpfr_get_d(number_, rounding);
  }
  [[nodiscard]] double value() const { return mpfr_get_d(number_, rounding_); }

 private:
  mpfr_t number_;
  mpfr_rnd_t rounding_;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bounds that all numbers keep, or none.
void require_bounds(const Enclosure& e) {
  if (std::isnan(e.lower) || std::isnan(e.upper) || e.lower == kInfinity || e.upper == -kInfinity) {
    throw Error(Errc::invalid_argument,
                "an enclosure's bounds must be numbers, or infinite away from each other");
  }
}

double sum(double a, double b, mpfr_rnd_t rounding) {
  if (std::isinf(a) || std::isinf(b)) {
    return std::isinf(a) ? a : b;
  }
  return Directed(mpq_class(a) + mpq_class(b), rounding).value();
}

}  // namespace

Enclosure enclosure_of(const mpq_class& value) {
  return {Directed(value, MPFR_RNDD).value(), Directed(value, MPFR_RNDU).value()};
}

Enclosure root_of(const mpq_class& square) {
  return {Directed(square, MPFR_RNDD).square_root().value(),
          Directed(square, MPFR_RNDU).square_root().value()};
}

Enclosure angle_of(const mpq_class& sine_squared, const mpq_class& cosine) {
  // The angle falls as the cosine grows, and grows with the sine before the right angle, falls with
  // it after.
  const mpfr_rnd_t down = cosine < 0 ? MPFR_RNDU : MPFR_RNDD;
  const mpfr_rnd_t up = cosine < 0 ? MPFR_RNDD : MPFR_RNDU;
  const Directed large(cosine, MPFR_RNDU), small(cosine, MPFR_RNDD);
  return {Directed(sine_squared, down).square_root().angle_above(large, MPFR_RNDD),
          Directed(sine_squared, up).square_root().angle_above(small, MPFR_RNDU)};
}

Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  require_bounds(a);
  require_bounds(b);
  return {sum(a.lower, b.lower, MPFR_RNDD), sum(a.upper, b.upper, MPFR_RNDU)};
}

}  // namespace dupin
