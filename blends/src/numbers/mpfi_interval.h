#pragma once

#include <mpfi.h>

#include "dupin/kernel/enclosure.h"

namespace dupin::numbers {

/// An interval of MPFI with ends of so many bits, rounded outward by every operation. It is total,
/// as Interval is: what has no result is the whole line.
template <mpfr_prec_t bits>
class MpfiInterval {
 public:
  MpfiInterval(double value = 0) : MpfiInterval(Raw{}) {
    mpfi_set_d(value_, value);
    make_total();
  }
  MpfiInterval(const MpfiInterval& other) : MpfiInterval(Raw{}) { mpfi_set(value_, other.value_); }
  MpfiInterval& operator=(const MpfiInterval& other) {
    mpfi_set(value_, other.value_);
    return *this;
  }
  ~MpfiInterval() { mpfi_clear(value_); }

  /// A rational number.
  explicit MpfiInterval(const mpq_class& value) : MpfiInterval(Raw{}) {
    mpfi_set_q(value_, value.get_mpq_t());
  }
  [[nodiscard]] static MpfiInterval between(double lower, double upper) {
    MpfiInterval result{Raw{}};
    mpfi_interv_d(result.value_, lower, upper);
    if (!(lower <= upper)) {  // mpfi would exchange them
      mpfr_set_nan(&result.value_->left);
    }
    result.make_total();
    return result;
  }

  [[nodiscard]] static MpfiInterval pi() { return made(mpfi_const_pi); }

  friend MpfiInterval operator+(const MpfiInterval& a, const MpfiInterval& b) {
    return made(mpfi_add, a, b);
  }
  friend MpfiInterval operator-(const MpfiInterval& a, const MpfiInterval& b) {
    return made(mpfi_sub, a, b);
  }
  friend MpfiInterval operator*(const MpfiInterval& a, const MpfiInterval& b) {
    return made(mpfi_mul, a, b);
  }
  friend MpfiInterval operator/(const MpfiInterval& a, const MpfiInterval& b) {
    return made(mpfi_div, a, b);
  }
  /// The angle of the point (x, y).
  friend MpfiInterval angle(const MpfiInterval& y, const MpfiInterval& x) {
    return made(mpfi_atan2, y, x);
  }
  friend MpfiInterval cosine(const MpfiInterval& a) { return made(mpfi_cos, a); }
  friend MpfiInterval sine(const MpfiInterval& a) { return made(mpfi_sin, a); }
  friend MpfiInterval square(const MpfiInterval& a) { return made(mpfi_sqr, a); }
  friend MpfiInterval square_root(const MpfiInterval& a) { return made(mpfi_sqrt, a); }
  friend MpfiInterval magnitude(const MpfiInterval& a) { return made(mpfi_abs, a); }

  [[nodiscard]] bool is_positive() const { return mpfi_is_strictly_pos(value_) > 0; }
  // Zeros are +0: people read them.
  [[nodiscard]] Enclosure rounded_outward() const {
    return {mpfr_get_d(&value_->left, MPFR_RNDD), 0.0 + mpfr_get_d(&value_->right, MPFR_RNDU)};
  }

 private:
  struct Raw {};
  explicit MpfiInterval(Raw) { mpfi_init2(value_, bits); }

  template <class Operation, class... Operand>
  static MpfiInterval made(Operation operation, const Operand&... operands) {
    MpfiInterval result{Raw{}};
    operation(result.value_, operands.value_...);
    result.make_total();
    return result;
  }

  void make_total() {
    if (mpfi_nan_p(value_) != 0) {
      mpfr_set_inf(&value_->left, -1);
      mpfr_set_inf(&value_->right, 1);
    }
  }

  mpfi_t value_;
};

}  // namespace dupin::numbers
