#include "curves/exact_radius.h"

#include <algorithm>

#include "numbers/mpfi_interval.h"

namespace dupin::curves {
namespace {

using Mpfi = numbers::MpfiInterval<128>;

}  // namespace

std::optional<numbers::Polynomial> polynomial(const RadiusLaw& law) {
  struct Visitor {
    std::optional<numbers::Polynomial> operator()(const ConstantRadius& l) const {
      return numbers::Polynomial{numbers::exact(l.radius)};
    }
    std::optional<numbers::Polynomial> operator()(const LinearRadius& l) const {
      return numbers::Polynomial{numbers::exact(l.start),
                                 numbers::exact(l.end) - numbers::exact(l.start)};
    }
    std::optional<numbers::Polynomial> operator()(const CubicRadius& l) const {
      const mpq_class rise = numbers::exact(l.end) - numbers::exact(l.start);
      return numbers::Polynomial{l.start, 0, 3 * rise, -2 * rise};
    }
    std::optional<numbers::Polynomial> operator()(const BezierRadius& l) const {
      std::vector<mpq_class> coefficients;
      for (const double c : l.coefficients) {
        coefficients.push_back(numbers::exact(c));
      }
      return numbers::power_basis(coefficients);
    }
    std::optional<numbers::Polynomial> operator()(const CyclideRadius&) const {
      return std::nullopt;
    }
  };
  return std::visit(Visitor{}, law);
}

numbers::Interval enclosed_radius(const CyclideRadius& law, double t) {
  if (t == 0 || t == 1) {
    const double end = t == 0 ? law.start : law.end;
    return {end, end};
  }
  const Mpfi start = law.start, end = law.end;
  const Mpfi c = (end - start) * cosine(Mpfi::pi() * t);
  // With 128 bits the plain root loses to cancellation at most what extreme radius ratios beyond
  // 2^60 would notice; the enclosure stays true regardless.
  const Enclosure radius = ((square_root(square(c) + 4 * start * end) - c) / 2).rounded_outward();
  return {radius.lower, radius.upper};
}

double second_derivative_bound(const CyclideRadius& law) {
  // R'' = pi (pi c R/w + s R'/w + pi c s^2 R/w^3) with R' = pi s R/w, c = D cos(pi t),
  // s = D sin(pi t), w^2 = c^2 + 4 r0 r1. From |c| <= w, |s| <= |D|, w^2 >= 4 r0 r1:
  // |R''| <= pi^2 max(R) (1 + D^2 / (2 r0 r1)).
  const Mpfi start = law.start, end = law.end, largest = std::max(law.start, law.end);
  const Mpfi bound = square(Mpfi::pi()) * largest * (1 + square(end - start) / (2 * start * end));
  return bound.rounded_outward().upper;
}

}  // namespace dupin::curves
