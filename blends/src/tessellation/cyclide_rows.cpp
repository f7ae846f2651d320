#include "tessellation/cyclide_rows.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "tessellation/tessellation_tolerance.h"

namespace dupin::tessellation {
namespace {

// Cells of a piece on which the second derivatives are bounded once. They vary with the cosine of
// at most a turn over a piece, so that the bounds exceed the suprema by a few percent.
constexpr std::uint32_t kCells = 32;

}  // namespace

BandStepper march_of(const PeArc& arc, double around) {
  const cyclide::ArcConstants constants(arc);
  std::vector<ringed::BandBounds> cells;
  cells.reserve(kCells);
  for (std::uint32_t i = 0; i < kCells; ++i) {
    cells.push_back(
        cyclide::band_bounds(arc, constants, double(i) / kCells, double(i + 1) / kCells));
  }
  return {std::move(cells), around};
}

// The radius of a piece's spheres is convex, concave or monotone: the largest is at an end or near
// the largest of samples, which the bounds of the cells (not this estimate) make certain.
double largest_circle(const PeArc& arc) {
  double largest = 0;
  for (std::uint32_t i = 0; i <= kCells; ++i) {
    largest =
        std::max(largest, circle_at(arc, cyclide::parameter_at(arc, double(i) / kCells)).radius);
  }
  return largest;
}

// A point is N / W with quadratics N and W, where W is at least (1 + w) / 2.
double point_error(const PeArc& arc, double grid) {
  double size = 0;
  for (const auto& [sphere, weight] : bezier_points(arc)) {
    size += sphere.m.norm() + std::abs(sphere.r);
  }
  return point_error(size * std::max(1.0, 2 / (1 + arc.w())), grid);
}

Row row_at(const PeArc& arc, double fraction, const Vec3& plane_normal) {
  const Ring circle = circle_at(arc, cyclide::parameter_at(arc, fraction));
  return {circle.center, plane_normal.cross(circle.normal).normalized(), plane_normal,
          circle.radius, 0};
}

}  // namespace dupin::tessellation
