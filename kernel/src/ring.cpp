#include "dupin/kernel/ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// Of the two normals of a circle's plane, the one whose first non-zero coordinate is positive: the
// same for a ring and its flip.
bool is_canonical(const Vec3& normal) {
  for (const double x : normal) {
    if (x != 0) {
      return x > 0;
    }
  }
  return true;
}

Vec3 negated(const Vec3& v) {
  return Vec3::Zero() - v;  // not -v: 0 stays +0
}

Vec3 canonical_normal(const Vec3& normal) {
  return is_canonical(normal) ? normal : negated(normal);
}

Vec3 axis_of(const Vec3& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 across = Vec3::Unit(smallest).cross(normal);
  return across.normalized();
}

}  // namespace

Ring flipped(const Ring& ring) {
  return {ring.center, negated(ring.normal), ring.radius, 0.0 - ring.slope};
}

void validate(const Ring& ring) {
  if (!ring.center.allFinite() || !ring.normal.allFinite() || !std::isfinite(ring.radius) ||
      !std::isfinite(ring.slope)) {
    throw Error(Errc::invalid_argument,
                "a ring's centre, normal, radius and slope must be finite numbers");
  }
  if (ring.radius <= 0) {
    throw Error(Errc::invalid_argument,
                "a ring's radius must be positive, not " + std::to_string(ring.radius));
  }
  // A normal that came from one normalisation is unit to 2 ulp; 1e-9 admits typed-in ones and turns
  // no point by more than that.
  if (std::abs(ring.normal.norm() - 1) > 1e-9) {
    throw Error(Errc::invalid_argument,
                "a ring's normal must have unit length, not " + std::to_string(ring.normal.norm()));
  }
}

Vec3 reference_axis(const Ring& ring) { return axis_of(canonical_normal(ring.normal)); }

Vec3 snapped(const Vec3& point, double grid) {
  if (grid == 0) {
    return point;
  }
  return (point / grid).unaryExpr([](double x) { return std::nearbyint(x) + 0.0; }) * grid;
}

std::vector<Vec3> sample(const Ring& ring, const RingSampling& sampling) {
  validate(ring);
  if (sampling.segments < 3) {
    throw Error(Errc::invalid_argument,
                "a ring needs at least 3 segments, not " + std::to_string(sampling.segments));
  }
  const Vec3 normal = canonical_normal(ring.normal);
  const Vec3 u = axis_of(normal);
  const Vec3 v = normal.cross(u);
  std::vector<Vec3> points;
  points.reserve(sampling.segments);
  for (std::uint32_t i = 0; i < sampling.segments; ++i) {
    const double angle = 2 * std::numbers::pi * (i + sampling.phase) / sampling.segments;
    const Vec3 offset = ring.radius * (std::cos(angle) * u + std::sin(angle) * v);
    points.push_back(snapped(ring.center + offset, sampling.grid));
  }
  if (!is_canonical(ring.normal)) {
    std::reverse(points.begin() + 1, points.end());
  }
  return points;
}

}  // namespace dupin
