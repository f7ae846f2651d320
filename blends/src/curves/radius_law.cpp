#include "dupin/blends/radius_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "numbers/bezier.h"

namespace dupin {
namespace {

RadiusValue at(const ConstantRadius& law, double) { return {law.radius, 0, 0}; }

RadiusValue at(const LinearRadius& law, double t) {
  return {std::lerp(law.start, law.end, t), law.end - law.start, 0};
}

RadiusValue at(const CubicRadius& law, double t) {
  const double rise = law.end - law.start;
  return {t == 1 ? law.end : law.start + rise * t * t * (3 - 2 * t), 6 * rise * t * (1 - t),
          6 * rise * (1 - 2 * t)};
}

RadiusValue at(const CyclideRadius& law, double t) {
  constexpr double kPi = std::numbers::pi;
  const double rise = law.end - law.start;
  // In these forms both vanish exactly where they should: flat ends, no error at the middle.
  const double c = rise * std::sin(kPi * (0.5 - t)), s = rise * std::sin(kPi * std::min(t, 1 - t));
  const double product = law.start * law.end;
  const double w = std::sqrt(c * c + 4 * product);
  // The root in the form that adds equal signs: no cancellation.
  const double root = c <= 0 ? (w - c) / 2 : 2 * product / (w + c);
  const double radius = t == 0 ? law.start : t == 1 ? law.end : root;
  const double first = kPi * s * radius / w;
  const double second =
      kPi * (kPi * c * radius / w + s * first / w + kPi * c * s * s * radius / (w * w * w));
  return {radius, first, second};
}

RadiusValue at(const BezierRadius& law, double t) {
  const auto [value, first, second, third] = numbers::bezier_jet(law.coefficients, t);
  return {value, first, second};
}

std::pair<double, double> extremes(const RadiusLaw& law) {
  struct Visitor {
    std::pair<double, double> operator()(const ConstantRadius& l) const {
      return {l.radius, l.radius};
    }
    std::pair<double, double> operator()(const BezierRadius& l) const {
      const auto [least, most] = std::minmax_element(l.coefficients.begin(), l.coefficients.end());
      return {*least, *most};
    }
    std::pair<double, double> operator()(const LinearRadius& l) const {
      return std::minmax(l.start, l.end);
    }
    std::pair<double, double> operator()(const CubicRadius& l) const {
      return std::minmax(l.start, l.end);
    }
    std::pair<double, double> operator()(const CyclideRadius& l) const {
      return std::minmax(l.start, l.end);
    }
  };
  return std::visit(Visitor{}, law);
}

}  // namespace

RadiusValue evaluate(const RadiusLaw& law, double t) {
  return std::visit([t](const auto& l) { return at(l, t); }, law);
}

bool is_linear(const RadiusLaw& law) {
  return std::holds_alternative<ConstantRadius>(law) || std::holds_alternative<LinearRadius>(law);
}

double largest_radius(const RadiusLaw& law) { return extremes(law).second; }

double smallest_radius(const RadiusLaw& law) { return extremes(law).first; }

}  // namespace dupin
