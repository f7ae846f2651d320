#include "dupin/kernel/enclosure.h"

#include <mpfr.h>

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
  return {Directed(mpq_class(a.lower) + mpq_class(b.lower), MPFR_RNDD).value(),
          Directed(mpq_class(a.upper) + mpq_class(b.upper), MPFR_RNDU).value()};
}

}  // namespace dupin
