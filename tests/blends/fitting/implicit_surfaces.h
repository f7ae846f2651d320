#pragma once

#include <cmath>

#include "dupin/blends/ringed_fit.h"

/// Surfaces f = 0 that everybody knows.
namespace dupin::test {

/// The same with a gradient by central differences.
inline ImplicitSurface by_differences(std::function<double(const Vec3&)> value) {
  const auto gradient = [value](const Vec3& p) {
    constexpr double kStep = 1e-5;
    Vec3 result;
    for (int i = 0; i < 3; ++i) {
      const Vec3 h = kStep * Vec3::Unit(i);
      result[i] = (value(p + h) - value(p - h)) / (2 * kStep);
    }
    return result;
  };
  return {std::move(value), gradient};
}

inline ImplicitSurface sphere(double radius) {
  return {[=](const Vec3& p) { return p.squaredNorm() - radius * radius; },
          [](const Vec3& p) { return Vec3(2 * p); }};
}

/// About the z axis; `height` stretches its sections along it.
inline ImplicitSurface torus(double bend, double radius, double height = 1) {
  return {[=](const Vec3& p) {
            const double out = std::hypot(p[0], p[1]) - bend;
            return out * out + p[2] * p[2] / (height * height) - radius * radius;
          },
          [=](const Vec3& p) {
            const double from_axis = std::hypot(p[0], p[1]),
                         factor = 2 * (from_axis - bend) / from_axis;
            return Vec3(factor * p[0], factor * p[1], 2 * p[2] / (height * height));
          }};
}

/// The Dupin cyclide of [mathematics B1]: (x^2 + y^2 + z^2 - mu^2 + b^2)^2 = 4 (a x - c mu)^2 +
/// 4 b^2 y^2, b^2 = a^2 - c^2.
inline ImplicitSurface cyclide(double a, double c, double mu) {
  const double b2 = a * a - c * c;
  return {[=](const Vec3& p) {
            const double s = p.squaredNorm() - mu * mu + b2, l = a * p[0] - c * mu;
            return s * s - 4 * l * l - 4 * b2 * p[1] * p[1];
          },
          [=](const Vec3& p) {
            const double s = p.squaredNorm() - mu * mu + b2, l = a * p[0] - c * mu;
            return Vec3(4 * s * p - Vec3(8 * l * a, 8 * b2 * p[1], 0));
          }};
}

}  // namespace dupin::test
