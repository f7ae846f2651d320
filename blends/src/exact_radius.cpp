#include "exact_radius.h"

#include <algorithm>
#include <cmath>

#include <mpfi.h>

namespace dupin::detail {
namespace {

// The one place that owns an mpfi_t.
class Mpfi {
 public:
  explicit Mpfi(double value = 0) {
    mpfi_init2(value_, kBits);
    mpfi_set_d(value_, value);
  }
  ~Mpfi() { mpfi_clear(value_); }
  Mpfi(const Mpfi&) = delete;
  Mpfi& operator=(const Mpfi&) = delete;

  [[nodiscard]] mpfi_ptr get() { return value_; }
  [[nodiscard]] Interval rounded_outward() const {
    Interval result;
    result.lower = mpfr_get_d(&value_->left, MPFR_RNDD);
    result.upper = mpfr_get_d(&value_->right, MPFR_RNDU);
    return result;
  }

 private:
  static constexpr mpfr_prec_t kBits = 128;
  mpfi_t value_;
};

}  // namespace

std::optional<Polynomial> polynomial(const RadiusLaw& law) {
  struct Visitor {
    std::optional<Polynomial> operator()(const ConstantRadius& l) const {
      return Polynomial{l.radius};
    }
    std::optional<Polynomial> operator()(const LinearRadius& l) const {
      return Polynomial{l.start, mpq_class(l.end) - l.start};
    }
    std::optional<Polynomial> operator()(const CubicRadius& l) const {
      const mpq_class rise = mpq_class(l.end) - l.start;
      return Polynomial{l.start, 0, 3 * rise, -2 * rise};
    }
    std::optional<Polynomial> operator()(const BezierRadius& l) const {
      return power_basis(std::vector<mpq_class>(l.coefficients.begin(), l.coefficients.end()));
    }
    std::optional<Polynomial> operator()(const CyclideRadius&) const { return std::nullopt; }
  };
  return std::visit(Visitor{}, law);
}

Interval enclosed_radius(const CyclideRadius& law, double t) {
  if (t == 0 || t == 1) {
    const double end = t == 0 ? law.start : law.end;
    return {end, end};
  }
  Mpfi c, product(law.start), w, rise(law.end);
  mpfi_sub_d(rise.get(), rise.get(), law.start);
  mpfi_const_pi(c.get());
  mpfi_mul_d(c.get(), c.get(), t);
  mpfi_cos(c.get(), c.get());
  mpfi_mul(c.get(), c.get(), rise.get());
  mpfi_mul_d(product.get(), product.get(), law.end);
  mpfi_mul_ui(product.get(), product.get(), 4);
  mpfi_sqr(w.get(), c.get());
  mpfi_add(w.get(), w.get(), product.get());
  mpfi_sqrt(w.get(), w.get());
  // With 128 bits the plain root loses to cancellation at most what extreme radius ratios beyond
  // 2^60 would notice; the enclosure stays true regardless.
  mpfi_sub(w.get(), w.get(), c.get());
  mpfi_div_ui(w.get(), w.get(), 2);
  return w.rounded_outward();
}

double second_derivative_bound(const CyclideRadius& law) {
  // R'' = pi (pi c R/w + s R'/w + pi c s^2 R/w^3) with R' = pi s R/w, c = D cos(pi t),
  // s = D sin(pi t), w^2 = c^2 + 4 r0 r1. From |c| <= w, |s| <= |D|, w^2 >= 4 r0 r1:
  // |R''| <= pi^2 max(R) (1 + D^2 / (2 r0 r1)).
  Mpfi bound(law.end), product(law.start), pi;
  mpfi_sub_d(bound.get(), bound.get(), law.start);
  mpfi_sqr(bound.get(), bound.get());
  mpfi_mul_d(product.get(), product.get(), law.end);
  mpfi_div(bound.get(), bound.get(), product.get());
  mpfi_div_ui(bound.get(), bound.get(), 2);
  mpfi_add_ui(bound.get(), bound.get(), 1);
  mpfi_const_pi(pi.get());
  mpfi_sqr(pi.get(), pi.get());
  mpfi_mul(bound.get(), bound.get(), pi.get());
  mpfi_mul_d(bound.get(), bound.get(), std::max(law.start, law.end));
  return bound.rounded_outward().upper;
}

}  // namespace dupin::detail
