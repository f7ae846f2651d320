#include <algorithm>
#include <cmath>
#include <numbers>

#include "dupin/blends/tessellate.h"
#include "tessellation/loft.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

// Cells of [0, 1] on which the second derivatives are bounded once.
constexpr std::uint32_t kCells = 1024;

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

tessellation::LoftRow row_at(const RationalRingedSurface& surface, double t) {
  const Vec3 center = ring_at(surface, t).center;
  return {center, evaluate(surface, t, 0).position - center,
          evaluate(surface, t, std::numbers::pi / 2).position - center};
}

}  // namespace

std::uint32_t segments_for(const RationalRingedTube& tube, double tolerance, double grid) {
  const double allowed = tessellation::allowed_error(tolerance, point_error(tube.surface, grid));
  return tessellation::segment_count(2 * std::numbers::pi *
                                     std::sqrt(largest_radius(tube.surface) / (2 * allowed)));
}

Tessellation tessellate(const RationalRingedTube& tube, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = point_error(tube.surface, sampling.grid);
  std::vector<ringed::BandBounds> cells;
  for (std::uint32_t i = 0; i < kCells; ++i) {
    cells.push_back(ringed::band_bounds(tube.surface, double(i) / kCells, double(i + 1) / kCells));
  }
  const auto bands = tessellation::loft_bands(
      std::move(cells), tessellation::allowed_error(options.tolerance, displacement),
      largest_radius(tube.surface), sampling.segments);
  std::vector<tessellation::LoftRow> rows;
  for (const double t : bands.knots) {
    rows.push_back(row_at(tube.surface, t));
  }
  return {tessellation::lofted(tube.start, tube.end, rows, sampling),
          std::uint32_t(rows.size() - 1), bands.error_bound + displacement, bands.knots};
}

}  // namespace dupin
