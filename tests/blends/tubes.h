#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "dupin/blends/ringed_surface.h"

/// Tubes of a few numbers, whose discs everybody knows.
namespace dupin::test {

inline RingedSurface cone(const Vec3& from, const Vec3& to, double start, double end) {
  const Vec3 along = (to - from).normalized();
  const double slope = (end - start) / (to - from).norm();
  return {flipped(Ring{from, along, start, slope}),
          {to, along, end, slope},
          LineSpine{from, to},
          LinearRadius{start, end}};
}

inline RingedSurface cylinder(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = (to - from).normalized();
  return {{from, -along, radius}, {to, along, radius}, LineSpine{from, to}, ConstantRadius{radius}};
}

/// About the z axis from (bend, 0, 0) towards y.
inline RingedSurface elbow(double bend, double angle, double radius) {
  const auto at = [=](double a) { return Vec3(bend * std::cos(a), bend * std::sin(a), 0); };
  const auto along = [](double a) { return Vec3(-std::sin(a), std::cos(a), 0); };
  return {{at(0), -along(0), radius},
          {at(angle), along(angle), radius},
          ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), at(0), angle},
          ConstantRadius{radius}};
}

}  // namespace dupin::test
