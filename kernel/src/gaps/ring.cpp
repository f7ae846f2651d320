#include "dupin/kernel/ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
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

void require_positive(double radius) {
  if (radius <= 0) {
    throw Error(Errc::invalid_argument,
                "a ring's radius must be positive, not " + decimal(radius, kMessageDigits));
  }
}

void validate(const Ellipse& ellipse, const Vec3& normal) {
  if (!ellipse.axis.allFinite() || !std::isfinite(ellipse.across) ||
      !std::isfinite(ellipse.across_slope)) {
    throw Error(Errc::invalid_argument, "an elliptic ring's numbers must be finite");
  }
  require_positive(ellipse.across);
  // As for a ring's normal: typed-in numbers are admitted, and nothing turns by more than that.
  if (std::abs(ellipse.axis.norm() - 1) > 1e-9 || std::abs(ellipse.axis.dot(normal)) > 1e-9) {
    throw Error(Errc::invalid_argument,
                "an elliptic ring's axis must have unit length and be orthogonal to its normal");
  }
}

}  // namespace

Ring flipped(const Ring& ring) {
  Ring result{ring.center, negated(ring.normal), ring.radius, 0.0 - ring.slope, ring.ellipse};
  if (result.ellipse) {
    result.ellipse->across_slope = 0.0 - result.ellipse->across_slope;
  }
  return result;
}

double circle_distance(const Ring& a, const Ring& b) {
  const double tilt = std::min((a.normal - b.normal).norm(), (a.normal + b.normal).norm());
  return (a.center - b.center).norm() + std::abs(a.radius - b.radius) +
         std::min(a.radius, b.radius) * tilt;
}

double across(const Ring& ring) { return ring.ellipse ? ring.ellipse->across : ring.radius; }

double across_slope(const Ring& ring) {
  return ring.ellipse ? ring.ellipse->across_slope : ring.slope;
}

double largest_radius(const Ring& ring) { return std::max(ring.radius, across(ring)); }

void validate(const Ring& ring) {
  if (!ring.center.allFinite() || !ring.normal.allFinite() || !std::isfinite(ring.radius) ||
      !std::isfinite(ring.slope)) {
    throw Error(Errc::invalid_argument,
                "a ring's centre, normal, radius and slope must be finite numbers");
  }
  require_positive(ring.radius);
  // A normal that came from one normalisation is unit to 2 ulp; 1e-9 admits typed-in ones and turns
  // no point by more than that.
  if (std::abs(ring.normal.norm() - 1) > 1e-9) {
    throw Error(Errc::invalid_argument, "a ring's normal must have unit length, not " +
                                            decimal(ring.normal.norm(), kPlaceDigits));
  }
  if (ring.ellipse) {
    validate(*ring.ellipse, ring.normal);
  }
}

Vec3 reference_axis(const Ring& ring) {
  return ring.ellipse ? ring.ellipse->axis : axis_of(canonical_normal(ring.normal));
}

Vec3 snapped(const Vec3& point, double grid) {
  if (grid == 0) {
    return point;
  }
  return point.unaryExpr([&](double x) {
    constexpr double kAllWhole = 0x1p52;  // all doubles from there on
    const double steps = x / grid;
    return std::abs(steps) < kAllWhole ? (std::nearbyint(steps) + 0.0) * grid : x;
  });
}

std::vector<Vec3> sample(const Ring& ring, const RingSampling& sampling) {
  validate(ring);
  if (sampling.segments < 3) {
    throw Error(Errc::invalid_argument,
                "a ring needs at least 3 segments, not " + std::to_string(sampling.segments));
  }
  constexpr std::uint32_t kMostSegments = 100'000'000;
  if (sampling.segments > kMostSegments) {
    throw Error(Errc::limit_exceeded, "a ring has at most " + std::to_string(kMostSegments) +
                                          " segments, not " + std::to_string(sampling.segments));
  }
  if (!std::isfinite(sampling.phase) || !std::isfinite(sampling.grid)) {
    throw Error(Errc::invalid_argument, "the phase and the grid of a sampling must be finite");
  }
  const Vec3 normal = canonical_normal(ring.normal);
  const Vec3 u = reference_axis(ring);
  const Vec3 v = normal.cross(u);
  std::vector<Vec3> points;
  points.reserve(sampling.segments);
  for (std::uint32_t i = 0; i < sampling.segments; ++i) {
    const double angle = 2 * std::numbers::pi * (i + sampling.phase) / sampling.segments;
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec3 offset = ring.ellipse ? Vec3(ring.radius * c * u + ring.ellipse->across * s * v)
                                     : Vec3(ring.radius * (c * u + s * v));
    points.push_back(snapped(ring.center + offset, sampling.grid));
  }
  if (!std::ranges::all_of(points, [](const Vec3& point) { return point.allFinite(); })) {
    throw Error(Errc::invalid_argument, "the points of a ring are too far away for doubles");
  }
  if (!is_canonical(ring.normal)) {
    std::reverse(points.begin() + 1, points.end());
  }
  return points;
}

}  // namespace dupin
