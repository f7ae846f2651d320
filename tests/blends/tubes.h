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

/// The same by at most a half turn, on a rational Bezier curve, which does not say that it is an
/// arc.
inline RingedSurface elbow_of_bezier(double bend, double angle, double radius) {
  RingedSurface result = elbow(bend, angle, radius);
  const double c = std::cos(angle / 2), weight = (1 + 2 * c) / 3;
  const Vec3 from = std::get<ArcSpine>(result.spine).start, to = result.end.center;
  const Vec3 corner = 2 * bend * Vec3(c, std::sin(angle / 2), 0);  // times the cosine
  result.spine = BezierSpine{{from, (from + corner) / (1 + 2 * c), (to + corner) / (1 + 2 * c), to},
                             {1, weight, weight, 1}};
  return result;
}

/// A cylinder on a Bezier curve, which does not say that it is a line.
inline RingedSurface cylinder_of_bezier(const Vec3& from, const Vec3& to, double radius) {
  RingedSurface result = cylinder(from, to, radius);
  result.spine = BezierSpine{{from, (from + to) / 2, to}, {}};
  return result;
}

}  // namespace dupin::test
