#include "surfaces/pieces/elliptic_piece_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "ringed/second_derivatives.h"
#include "surfaces/exact_rows.h"
#include "tessellation/swept_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

double largest_radius(const EllipticTube& tube) {
  return std::max(largest_radius(tube.first), largest_radius(tube.second));
}

// A cylinder, or a cone of similar ellipses, whose end polygons begin at the same parameter: all
// its quadrilaterals are plane.
bool is_straight(const EllipticTube& tube) {
  const Ring &a = tube.start, &b = tube.end;
  return std::holds_alternative<LineSpine>(tube.spine) && is_linear(tube.first) &&
         is_linear(tube.second) && b.normal == flipped(a).normal && a.ellipse && b.ellipse &&
         a.ellipse->axis == b.ellipse->axis && a.radius * across(b) == b.radius * across(a);
}

// The frame along the spine, carried in minimal rotations T -> T' of `steps` per unit of t. A
// rotation by a drifts by less than 0.27 a^2 (see BandStepper), and the squares of the steps'
// angles add up to at most the mean of |T'|^2 over the steps.
struct Carrier {
  double steps = 1;
  double drift = 0;  // bound of the angle lost on the way
};

constexpr double kAxesShare = 1. / 64;  // of the tolerance: for what axes are off

// An axis that is off by an angle moves points of the ellipse along it by up to the difference of
// the semi-axes times that. The tube ends where its rings are, so that both ends' share counts.
Carrier carrier(const EllipticTube& tube, const tessellation::BandStepper& march,
                double tolerance) {
  constexpr double kFewestSteps = 1 << 10, kMostSteps = 1 << 20;
  const double lost = 0.27 * march.squared_turning();
  const double wanted = 2 * lost * largest_radius(tube) / (kAxesShare * tolerance);
  const double steps = std::clamp(std::ceil(wanted), kFewestSteps, kMostSteps);
  return {steps, lost / steps};
}

tessellation::BoundsOfCells bounds_of_cells(const EllipticTube& tube) {
  return tessellation::cell_by_cell(
      [&tube](double from, double to) { return ringed::band_bounds(tube, from, to); });
}

std::vector<Vec3> carried_along(const EllipticTube& tube, const std::vector<double>& knots,
                                double steps) {
  Vec3 tangent = evaluate(tube.spine, 0).first.normalized();
  Vec3 first = (tube.axis - tube.axis.dot(tangent) * tangent).normalized();
  std::vector<Vec3> result{first};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double width = knots[i + 1] - knots[i];
    const auto count = std::lround(std::ceil(width * steps));
    for (long step = 1; step <= count; ++step) {
      const double t = knots[i] + width * double(step) / double(count);
      const Vec3 next = evaluate(tube.spine, t).first.normalized();
      first = tessellation::carried(tangent, next, first);
      tangent = next;
    }
    first = (first - first.dot(tangent) * tangent).normalized();
    result.push_back(first);
  }
  return result;
}

double eased(const EllipticTube& tube, double t) {
  return tube.continuity == Continuity::g1 ? t * t * (3 - 2 * t)
                                           : t * t * t * (10 - t * (15 - 6 * t));
}

// What turns the carried frame onto the end's axis: of the angles that do, the nearest to the
// tube's.
double arrived_turn(const EllipticTube& tube, const Vec3& first) {
  if (!tube.end.ellipse) {
    return tube.turn;
  }
  const Vec3 tangent = evaluate(tube.spine, 1).first.normalized();
  const Vec3& axis = tube.end.ellipse->axis;
  const double angle = std::atan2(axis.dot(tangent.cross(first)), axis.dot(first));
  return tube.turn + std::remainder(angle - tube.turn, std::numbers::pi);
}

std::vector<tessellation::Row> rows_at(const EllipticTube& tube, const std::vector<double>& knots,
                                       double steps) {
  const auto firsts = carried_along(tube, knots, steps);
  const double turn = arrived_turn(tube, firsts.back());
  std::vector<tessellation::Row> rows;
  for (std::size_t j = 0; j < knots.size(); ++j) {
    const SpinePoint y = evaluate(tube.spine, knots[j]);
    const Vec3 second = y.first.normalized().cross(firsts[j]);
    const double angle = turn * eased(tube, knots[j]);
    const double c = std::cos(angle), s = std::sin(angle);
    rows.push_back({y.position, evaluate(tube.first, knots[j]).value * (c * firsts[j] + s * second),
                    evaluate(tube.second, knots[j]).value * (c * second - s * firsts[j])});
  }
  return rows;
}

}  // namespace

namespace surfaces {

std::uint32_t segments_for(const EllipticTube& tube, double tolerance, double grid) {
  const double allowed =
      tessellation::allowed_error(tolerance, tessellation::point_error(tube, grid));
  const double radius = largest_radius(tube);
  if (is_straight(tube)) {
    return tessellation::segment_count(std::numbers::pi /
                                       std::acos(1 - std::min(allowed / radius, 1.0)));
  }
  // What rounding adds to the axes' share is less than another one.
  const double left = std::max(allowed - 2 * kAxesShare * tolerance, allowed / 2);
  return tessellation::segment_count(2 * std::numbers::pi * std::sqrt(radius / (2 * left)));
}

double expected_bands(const EllipticTube& tube, const RingSampling& sampling, double tolerance) {
  if (is_straight(tube)) {
    return 1;
  }
  return tessellation::expected_bands(
      bounds_of_cells(tube),
      tessellation::allowed_error(tolerance, tessellation::point_error(tube, sampling.grid)),
      largest_radius(tube), sampling.segments);
}

Tessellation tessellate(const EllipticTube& tube, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = tessellation::point_error(tube, sampling.grid);
  const double allowed = tessellation::allowed_error(options.tolerance, displacement);
  if (is_straight(tube)) {
    return {tessellation::swept_mesh(tube.start, tube.end, rows_at(tube, {0, 1}, 1), sampling),
            1,
            tessellation::sagitta(largest_radius(tube), sampling.segments) + displacement,
            {0, 1}};
  }
  const double radius = largest_radius(tube);
  const double around = 2 * std::numbers::pi / sampling.segments;
  const auto march = tessellation::fine_march(
      bounds_of_cells(tube), around, tessellation::band_budget(allowed, radius, around).enough);
  const Carrier frames = carrier(tube, march, options.tolerance);
  // Both ends' share, and what every rotation and sum is rounded by.
  const double axes = 2 * frames.drift + std::ldexp(frames.steps, -50);
  const double misplaced = axes * radius;
  const auto bands =
      tessellation::even_bands({march}, allowed - misplaced, radius, sampling.segments).front();
  const auto rows = rows_at(tube, bands.knots, frames.steps);
  return {tessellation::swept_mesh(tube.start, tube.end, rows, sampling),
          std::uint32_t(rows.size() - 1), bands.error_bound + misplaced + displacement, bands.knots,
          axes};
}

PieceExtent extent(const EllipticTube&, double) {
  return {std::numeric_limits<double>::infinity()};
}

MovingRing leaving(const EllipticTube& tube, End end) { return leaving_canal(end_ring(tube, end)); }

PieceDiscs discs(const EllipticTube& tube) { return discs_of(SweptDiscTube(tube), false); }

MarginBounds margin_bounds(const EllipticTube& tube) {
  const double lower = certified_margin(tube);
  return {lower, {}, lower > 0};
}

namespace {

// A surface with either semi-axis for a radius.
std::vector<RingedSurface> tubes_of(const EllipticTube& tube) {
  return {{tube.start, tube.end, tube.spine, tube.first},
          {tube.start, tube.end, tube.spine, tube.second}};
}

}  // namespace

double nearly_largest_margin(const EllipticTube& tube, double) {
  return nearly_largest_margin(tubes_of(tube));
}

ProvedStretches prove_margin(const EllipticTube& tube, double, double margin) {
  return prove_margin(tubes_of(tube), margin);
}

std::optional<double> tangency(const EllipticTube& tube, End end) {
  return tangency_bound(tube, end);
}

TangencyClaim tangency_claim(const EllipticTube& tube, End end) {
  const EndRing ring{end_ring(tube, end), end};
  const double t = ring.parameter();
  const auto stored = stored_end(tube.spine, end);
  const numbers::IntervalVec center =
      stored ? numbers::interval_vec(*stored) : discs(tube).hull({t, t}).centers.front();
  const numbers::Interval apart = numbers::norm(center - numbers::interval_vec(ring.ring.center));
  const numbers::Interval first = evaluate(tube.first, t).value,
                          second = evaluate(tube.second, t).value;
  return {
      tangency_bound(tube, end) * (1 + 0x1p-20),  // room for a checker's own rounding
      tangency_at_end(tubes_of(tube).front(), end).axis_angle.upper + 0.0,
      (apart + (first - ring.ring.radius).magnitude() + (second - across(ring.ring)).magnitude())
          .upper,
      {}};
}

NurbsForm nurbs(const EllipticTube& tube, double tolerance) {
  if (tube.turn == 0) {
    const auto [rows, degree] =
        surfaces::exact_rows(tube.spine, tube.first, tube.second, tube.axis);
    if (!rows.empty()) {
      return {{surfaces::nurbs_through(rows, degree)}, 0};
    }
  }
  return surfaces::lofted_nurbs(tube, tolerance);
}

}  // namespace surfaces
}  // namespace dupin
