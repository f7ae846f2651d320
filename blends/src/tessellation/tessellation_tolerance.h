#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/ringed_surface.h"

namespace dupin::tessellation {

/// How far a computed and snapped mesh point may lie from the point of the surface that is meant.
/// Half the diagonal of a lattice cell, and the rounding: a point is a sum of fewer than 32 terms
/// none of which exceeds `size`, each with a relative error below 2^-52.
inline double point_error(double size, double grid) {
  return std::numbers::sqrt3 / 2 * grid + std::ldexp(size, -47);
}

/// The sum of the lengths of all vectors that a spine is computed from.
inline double spine_size(const Spine& spine) {
  struct Size {
    double operator()(const LineSpine& line) const { return line.from.norm() + line.to.norm(); }
    double operator()(const ArcSpine& arc) const {
      return arc.center.norm() + (arc.start - arc.center).norm();
    }
    double operator()(const HermiteSpine& h) const {
      return h.from.norm() + h.to.norm() + h.start_velocity.norm() + h.end_velocity.norm();
    }
    double operator()(const BezierSpine& b) const {
      double sum = 0;
      for (const Vec3& point : b.points) {
        sum += point.norm();
      }
      return sum;
    }
  };
  return std::visit(Size(), spine);
}

inline double point_error(const RingedSurface& surface, double grid) {
  return point_error(spine_size(surface.spine) + surface.start.radius + surface.end.radius, grid);
}

inline double point_error(const EllipticTube& tube, double grid) {
  return point_error(spine_size(tube.spine) + largest_radius(tube.start) + largest_radius(tube.end),
                     grid);
}

inline double point_error(const Sphere& sphere, double grid) {
  return point_error(sphere.center.norm() + sphere.radius, grid);
}

/// What a tolerance leaves to chords. Throws Error{invalid_argument} if that is too little.
double allowed_error(double tolerance, double displacement);

/// The segments that a real number of them asks for: rounded up, at least 8. Throws
/// Error{limit_exceeded} beyond a million.
std::uint32_t segment_count(double wanted);

/// More triangles than these no part is made of: a build needs 400 bytes for each.
constexpr double kMostTriangles = 50'000'000;

/// "123456", "1.23 million", "1.23e+09".
[[nodiscard]] std::string count_text(double count);

/// Throws Error{limit_exceeded} for more than kMostTriangles.
void refuse_too_fine(double triangles);

}  // namespace dupin::tessellation
