#include "dupin/blends/tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "ringed/second_derivatives.h"
#include "tessellation/band_stepper.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

using tessellation::BandStepper;

// Cells of [0, 1] on which the second derivatives are bounded once; bands may end inside a cell.
// The interval bounds of so short a cell exceed the suprema by about a percent.
constexpr std::uint32_t kCells = 1024;

// A cylinder or cone whose end polygons are parallel and start at the same angle: its
// quadrilaterals are plane, and every plane across the axis cuts chords from circles.
bool is_straight(const RingedSurface& surface) {
  return std::holds_alternative<LineSpine>(surface.spine) &&
         (std::holds_alternative<ConstantRadius>(surface.radius) ||
          std::holds_alternative<LinearRadius>(surface.radius)) &&
         surface.end.normal == flipped(surface.start).normal;
}

// How far the arcs of a circle are from their chords.
double sagitta(double radius, std::uint32_t segments) {
  return radius * (1 - std::cos(std::numbers::pi / segments));
}

bool is_uniform(const RingedSurface& surface) {
  return (std::holds_alternative<LineSpine>(surface.spine) ||
          std::holds_alternative<ArcSpine>(surface.spine)) &&
         std::holds_alternative<ConstantRadius>(surface.radius);
}

tessellation::BandStepper march_of(const RingedSurface& surface, double around) {
  const std::uint32_t cells = is_uniform(surface) ? 1 : kCells;
  std::vector<ringed::BandBounds> bounds;
  bounds.reserve(cells);
  for (std::uint32_t i = 0; i < cells; ++i) {
    bounds.push_back(ringed::band_bounds(surface, double(i) / cells, double(i + 1) / cells));
  }
  return {std::move(bounds), around};
}

struct Bands {
  std::vector<double> knots;
  double error_bound = 0;
};

Bands bands(const RingedSurface& surface, double allowed, std::uint32_t segments) {
  const double around = 2 * std::numbers::pi / segments;
  if (is_straight(surface)) {
    return {{0, 1}, sagitta(largest_radius(surface.radius), segments)};
  }
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  const tessellation::BandStepper march = march_of(surface, around);
  const auto budget = tessellation::band_budget(allowed, largest_radius(surface.radius), around);
  const double twist = around / 2 / double(march.knots(budget.enough, 0, kNoLimit).size() - 1);
  auto knots = tessellation::even_knots(march, budget, twist);
  const double error_bound = march.error_bound(knots, twist);
  return {std::move(knots), error_bound};
}

// The smallest rotation that takes the unit vector `from` to `to`, applied to `v`; it never meets
// opposite vectors, as a step turns by less than a radian.
Vec3 carried(const Vec3& from, const Vec3& to, const Vec3& v) {
  const Vec3 axis = from.cross(to);
  return v + axis.cross(v) + axis.cross(axis.cross(v)) / (1 + from.dot(to));
}

// One direction across the spine per knot, turning no more than the tangent forces it to.
//
// FrameField is more accurate per step, but its drift has no proof; here it has (Band::shear).
std::vector<Vec3> carried_along(const Spine& spine, const std::vector<double>& knots, Vec3 first) {
  std::vector<Vec3> result{first};
  Vec3 tangent = evaluate(spine, 0).first.normalized();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::uint32_t step = 1; step <= tessellation::kFrameSteps; ++step) {
      const double t = knots[i] + (knots[i + 1] - knots[i]) * step / tessellation::kFrameSteps;
      const Vec3 next = evaluate(spine, t).first.normalized();
      first = carried(tangent, next, first);
      tangent = next;
    }
    first = (first - first.dot(tangent) * tangent).normalized();
    result.push_back(first);
  }
  return result;
}

}  // namespace

std::uint32_t segments_for(const RingedSurface& surface, double tolerance, double grid) {
  const double allowed =
      tessellation::allowed_error(tolerance, tessellation::point_error(surface, grid));
  const double radius = largest_radius(surface.radius);
  if (!is_straight(surface)) {
    return tessellation::segment_count(2 * std::numbers::pi * std::sqrt(radius / (2 * allowed)));
  }
  return tessellation::segment_count(std::numbers::pi /
                                     std::acos(1 - std::min(allowed / radius, 1.0)));
}

Tessellation tessellate(const RingedSurface& surface, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = tessellation::point_error(surface, sampling.grid);
  const std::uint32_t n = sampling.segments;
  const auto first_ring = sample(flipped(surface.start), sampling);
  const Bands along =
      bands(surface, tessellation::allowed_error(options.tolerance, displacement), n);
  const auto& knots = along.knots;
  const auto firsts = carried_along(
      surface.spine, knots, tessellation::first_direction(flipped(surface.start), sampling));
  const tessellation::Arrival last = tessellation::arrival(surface.end, sampling, firsts.back());

  Tessellation result{{}, std::uint32_t(knots.size() - 1), along.error_bound + displacement, knots};
  TriMesh& mesh = result.mesh = tessellation::first_row(first_ring, result.bands);
  for (std::size_t j = 1; j + 1 < knots.size(); ++j) {
    const SpinePoint y = evaluate(surface.spine, knots[j]);
    const double radius = evaluate(surface.radius, knots[j]).value;
    const Vec3& b1 = firsts[j];
    const Vec3 b2 = y.first.normalized().cross(b1);
    const double turned = last.twist * double(j) / result.bands;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n + turned;
      mesh.points.push_back(snapped(
          y.position + radius * (std::cos(angle) * b1 + std::sin(angle) * b2), sampling.grid));
    }
    tessellation::append_band(mesh, n);
  }
  mesh.points.insert(mesh.points.end(), last.points.begin(), last.points.end());
  tessellation::append_band(mesh, n);
  return result;
}

}  // namespace dupin
