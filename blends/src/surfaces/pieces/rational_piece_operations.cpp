#include "surfaces/pieces/rational_piece_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringed/second_derivatives.h"
#include "surfaces/nurbs_rows.h"
#include "tessellation/swept_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

// A Bezier curve's coefficients bound it.
double largest_radius(const RationalRingedSurface& surface) {
  return *std::max_element(surface.radius.begin(), surface.radius.end());
}

double point_error(const RationalRingedSurface& surface, double grid) {
  double size = largest_radius(surface);
  for (const Vec3& point : surface.center) {
    size += point.norm();
  }
  return tessellation::point_error(size, grid);
}

tessellation::Row row_at(const RationalRingedSurface& surface, double t) {
  const Vec3 center = ring_at(surface, t).center;
  return {center, evaluate(surface, t, 0).position - center,
          evaluate(surface, t, std::numbers::pi / 2).position - center};
}

tessellation::BoundsOfCells bounds_of_cells(const RationalRingedSurface& surface) {
  return tessellation::cell_by_cell(
      [&surface](double from, double to) { return ringed::band_bounds(surface, from, to); });
}

}  // namespace

namespace surfaces {

std::uint32_t segments_for(const RationalRingedTube& tube, double tolerance, double grid) {
  const double allowed = tessellation::allowed_error(tolerance, point_error(tube.surface, grid));
  return tessellation::segment_count(2 * std::numbers::pi *
                                     std::sqrt(largest_radius(tube.surface) / (2 * allowed)));
}

double expected_bands(const RationalRingedTube& tube, const RingSampling& sampling,
                      double tolerance) {
  return tessellation::expected_bands(
      bounds_of_cells(tube.surface),
      tessellation::allowed_error(tolerance, point_error(tube.surface, sampling.grid)),
      largest_radius(tube.surface), sampling.segments);
}

Tessellation tessellate(const RationalRingedTube& tube, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = point_error(tube.surface, sampling.grid);
  const auto bands = tessellation::even_bands(
      bounds_of_cells(tube.surface), tessellation::allowed_error(options.tolerance, displacement),
      largest_radius(tube.surface), sampling.segments);
  std::vector<tessellation::Row> rows;
  for (const double t : bands.knots) {
    rows.push_back(row_at(tube.surface, t));
  }
  return {tessellation::swept_mesh(tube.start, tube.end, rows, sampling),
          std::uint32_t(rows.size() - 1), bands.error_bound + displacement, bands.knots};
}

PieceExtent extent(const RationalRingedTube&, double) {
  return {std::numeric_limits<double>::infinity()};
}

MovingRing leaving(const RationalRingedTube& tube, End end) { return dupin::leaving(tube, end); }

PieceDiscs discs(const RationalRingedTube& tube) {
  return discs_of([surface = tube.surface](const numbers::Interval& t, bool steered) {
    return moving_disc(surface, t, steered);
  });
}

// Made regular, though barely where the bound is 0.
MarginBounds margin_bounds(const RationalRingedTube& tube) {
  return {certified_margin(tube.surface), {}, true};
}

namespace {

MarginOver margin_over(const RationalRingedTube& tube) {
  return [pace = discs(tube).pace](const ParameterInterval& t) { return margin_of(pace(t)); };
}

}  // namespace

double nearly_largest_margin(const RationalRingedTube& tube, double) {
  return nearly_largest_margin(margin_over(tube));
}

ProvedStretches prove_margin(const RationalRingedTube& tube, double, double margin) {
  return prove_margin(margin_over(tube), margin);
}

std::optional<double> tangency(const RationalRingedTube&, End) { return std::nullopt; }

TangencyClaim tangency_claim(const RationalRingedTube& tube, End end) {
  const EndRing ring{end_ring(tube, end), end};
  const DiscHull disc = discs(tube).hull({ring.parameter(), ring.parameter()});
  const numbers::IntervalVec& normal = disc.tangents.front();
  return {{},
          largest_angle(numbers::norm(numbers::cross(normal, ring.travel())),
                        numbers::dot(normal, ring.travel())),
          offset(ring, disc.centers.front(), disc.radius),
          {}};
}

// A quarter at a time, in the order of the columns.
NurbsForm nurbs(const RationalRingedTube& tube, double) {
  constexpr double kQuarter = std::numbers::pi / 2;
  NurbsSurface result;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const RationalPatch patch =
        rational_patch(tube.surface, quarter * kQuarter, (quarter + 1) * kQuarter);
    result.net.resize(patch.net.size());
    for (std::size_t i = 0; i < patch.net.size(); ++i) {
      auto& row = result.net[i];
      row.insert(row.end(), patch.net[i].begin() + (quarter > 0 ? 1 : 0), patch.net[i].end());
    }
  }
  result.degree_along = int(result.net.size()) - 1;
  result.knots_along = surfaces::bezier_knots(result.degree_along, 1);
  result.knots_around = surfaces::bezier_knots(2, 4);
  return {{result}, 0};
}

}  // namespace surfaces
}  // namespace dupin
