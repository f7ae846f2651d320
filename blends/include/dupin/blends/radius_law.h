#pragma once

#include <variant>
#include <vector>

namespace dupin {

/// R(t) = radius.
struct ConstantRadius {
  double radius = 1;
  friend bool operator==(const ConstantRadius&, const ConstantRadius&) = default;
};

/// R(t) = start + t (end - start): cones.
struct LinearRadius {
  double start = 1, end = 1;
  friend bool operator==(const LinearRadius&, const LinearRadius&) = default;
};

/// R1 of [MS06] eq. (5): start + (end - start)(3 t^2 - 2 t^3); slope zero at both ends.
struct CubicRadius {
  double start = 1, end = 1;
  friend bool operator==(const CubicRadius&, const CubicRadius&) = default;
};

/// R2 of [MS06] eq. (6): the positive root of R^2 + (end - start) cos(pi t) R - start end = 0;
/// slope zero at both ends. It is the radius law of a Dupin cyclide's circles, hence the name.
struct CyclideRadius {
  double start = 1, end = 1;
  friend bool operator==(const CyclideRadius&, const CyclideRadius&) = default;
};

/// R(t) with Bernstein coefficients; at least one. Positive coefficients make positive radii.
struct BezierRadius {
  std::vector<double> coefficients;
  friend bool operator==(const BezierRadius&, const BezierRadius&) = default;
};

/// The radius of a ringed surface's circles, for t in [0, 1].
using RadiusLaw =
    std::variant<ConstantRadius, LinearRadius, CubicRadius, CyclideRadius, BezierRadius>;

/// A radius and its derivatives with respect to t.
struct RadiusValue {
  double value = 0, first = 0, second = 0;
};

/// Exactly the end radii at t == 0 and t == 1.
[[nodiscard]] RadiusValue evaluate(const RadiusLaw& law, double t);

/// Whether it is a ConstantRadius or a LinearRadius.
[[nodiscard]] bool is_linear(const RadiusLaw& law);

/// An upper bound of the radii on [0, 1]; attained by all laws but BezierRadius.
[[nodiscard]] double largest_radius(const RadiusLaw& law);

/// A lower bound of the radii on [0, 1]; attained by all laws but BezierRadius.
[[nodiscard]] double smallest_radius(const RadiusLaw& law);

}  // namespace dupin
