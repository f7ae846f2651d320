#include "surfaces/pieces/ringed_piece_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/tangency.h"
#include "dupin/kernel/error.h"
#include "ringed/second_derivatives.h"
#include "surfaces/exact_rows.h"
#include "tessellation/swept_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

// A cylinder or cone whose end polygons are parallel and start at the same angle: its
// quadrilaterals are plane, and every plane across the axis cuts chords from circles.
bool is_straight(const RingedSurface& surface) {
  return std::holds_alternative<LineSpine>(surface.spine) && is_linear(surface.radius) &&
         surface.end.normal == flipped(surface.start).normal;
}

bool is_uniform(const RingedSurface& surface) {
  return (std::holds_alternative<LineSpine>(surface.spine) ||
          std::holds_alternative<ArcSpine>(surface.spine)) &&
         std::holds_alternative<ConstantRadius>(surface.radius);
}

tessellation::BoundsOfCells bounds_of_cells(const RingedSurface& surface) {
  return [&surface](std::uint32_t cells) {
    return ringed::band_bounds_of_cells(surface, is_uniform(surface) ? 1 : cells);
  };
}

tessellation::Bands bands(const RingedSurface& surface, double allowed, std::uint32_t segments) {
  if (is_straight(surface)) {
    return {{0, 1}, tessellation::sagitta(largest_radius(surface.radius), segments)};
  }
  return tessellation::even_bands(bounds_of_cells(surface), allowed, largest_radius(surface.radius),
                                  segments);
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
      first = tessellation::carried(tangent, next, first);
      tangent = next;
    }
    first = (first - first.dot(tangent) * tangent).normalized();
    result.push_back(first);
  }
  return result;
}

}  // namespace

namespace surfaces {

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

double expected_bands(const RingedSurface& surface, const RingSampling& sampling,
                      double tolerance) {
  if (is_straight(surface)) {
    return 1;
  }
  return tessellation::expected_bands(
      bounds_of_cells(surface),
      tessellation::allowed_error(tolerance, tessellation::point_error(surface, sampling.grid)),
      largest_radius(surface.radius), sampling.segments);
}

Tessellation tessellate(const RingedSurface& surface, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = tessellation::point_error(surface, sampling.grid);
  const auto [knots, error_bound] = bands(
      surface, tessellation::allowed_error(options.tolerance, displacement), sampling.segments);
  const auto firsts = carried_along(
      surface.spine, knots, tessellation::first_direction(flipped(surface.start), sampling));
  std::vector<tessellation::Row> inner;
  for (std::size_t j = 1; j + 1 < knots.size(); ++j) {
    const SpinePoint y = evaluate(surface.spine, knots[j]);
    inner.push_back({y.position, firsts[j], y.first.normalized().cross(firsts[j]),
                     evaluate(surface.radius, knots[j]).value, 0});
  }
  return {tessellation::swept_mesh(surface.start, inner,
                                   tessellation::arrival(surface.end, sampling, firsts.back()),
                                   sampling),
          std::uint32_t(knots.size() - 1), error_bound + displacement, knots};
}

PieceExtent extent(const RingedSurface& surface, double) {
  PieceExtent result{std::numeric_limits<double>::infinity()};
  if (std::holds_alternative<LineSpine>(surface.spine)) {
    result.smallest = (surface.end.center - surface.start.center).norm();
  }
  if (const auto* arc = std::get_if<ArcSpine>(&surface.spine)) {
    const double bend_radius = (arc->start - arc->center).norm();
    const double to_axis = bend_radius - largest_radius(surface.radius);
    const double open = std::max(2 * std::numbers::pi - arc->angle, 0.0);
    result.smallest = bend_radius * arc->angle;
    result.clearance = to_axis * std::min({arc->angle, open, 1.0});
  }
  return result;
}

MovingRing leaving(const RingedSurface& surface, End end) {
  return leaving_canal(end_ring(surface, end));
}

PieceDiscs discs(const RingedSurface& surface) { return discs_of(SweptDiscTube(surface), true); }

MarginBounds margin_bounds(const RingedSurface& surface) {
  const Regularity margin = regularity(surface);
  return {margin.lower, margin.upper, margin.lower > 0 || is_embedded_torus(surface)};
}

// Discs in half planes about one axis, each of them strictly on its side of it.
bool is_embedded_torus(const RingedSurface& surface) {
  const auto* arc = std::get_if<ArcSpine>(&surface.spine);
  const auto* radius = std::get_if<ConstantRadius>(&surface.radius);
  if (arc == nullptr || radius == nullptr || !(std::abs(arc->angle) < 2 * std::numbers::pi) ||
      !(std::isfinite(radius->radius) && radius->radius > 0) || !arc->start.allFinite() ||
      !arc->center.allFinite()) {
    return false;
  }
  mpq_class squared = 0;
  for (int i = 0; i < 3; ++i) {
    const mpq_class leg = mpq_class(arc->start[i]) - mpq_class(arc->center[i]);
    squared += leg * leg;
  }
  return squared > mpq_class(radius->radius) * mpq_class(radius->radius);
}

double nearly_largest_margin(const RingedSurface& surface, double) {
  return nearly_largest_margin(std::vector{surface});
}

ProvedStretches prove_margin(const RingedSurface& surface, double, double margin) {
  return prove_margin(std::vector{surface}, margin);
}

std::optional<double> tangency(const RingedSurface& surface, End end) {
  return tangency_at_end(surface, end).deviation.upper;
}

namespace {

// None where the surface folds. With room for a checker's own rounding.
std::optional<double> curvature(const RingedSurface& tube, End end) {
  try {
    const double bound = curvature_jump_bound(tube, end);
    const double radius = evaluate(tube.radius, end == End::end ? 1 : 0).value;
    const bool is_straight =
        std::holds_alternative<LineSpine>(tube.spine) && is_linear(tube.radius);
    return is_straight ? 0 : bound * (1 + 0x1p-20) + 0x1p-40 / radius;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

TangencyClaim tangency_claim(const RingedSurface& surface, End end) {
  const EndRing ring{end_ring(surface, end), end};
  const double t = ring.parameter();
  const Tangency found = tangency_at_end(surface, end);
  const auto stored = stored_end(surface.spine, end);
  const numbers::IntervalVec center =
      stored ? numbers::interval_vec(*stored) : discs(surface).hull({t, t}).centers.front();
  // Adding 0 takes the sign from a zero.
  return {found.deviation.upper + 0.0, found.axis_angle.upper + 0.0,
          offset(ring, center, evaluate(surface.radius, t).value), curvature(surface, end)};
}

NurbsForm nurbs(const RingedSurface& surface, double tolerance) {
  const auto [rows, degree] = surfaces::exact_rows(surface.spine, surface.radius, surface.radius,
                                                   reference_axis(surface.start));
  return rows.empty() ? surfaces::lofted_nurbs(surface, tolerance)
                      : NurbsForm{{surfaces::nurbs_through(rows, degree)}, 0};
}

}  // namespace surfaces
}  // namespace dupin
