#include <algorithm>
#include <cmath>
#include <numbers>

#include "chord_budget.h"
#include "dupin/blends/tessellate.h"
#include "loft.h"

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
  return detail::point_error(size, grid);
}

detail::LoftRow row_at(const RationalRingedSurface& surface, double t) {
  const Vec3 center = ring_at(surface, t).center;
  return {center, evaluate(surface, t, 0).position - center,
          evaluate(surface, t, std::numbers::pi / 2).position - center};
}

}  // namespace

std::uint32_t segments_for(const RingedTube& tube, double tolerance, double grid) {
  const double allowed = detail::allowed_error(tolerance, point_error(tube.surface, grid));
  return detail::segment_count(2 * std::numbers::pi *
                               std::sqrt(largest_radius(tube.surface) / (2 * allowed)));
}

Tessellation tessellate(const RingedTube& tube, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = point_error(tube.surface, sampling.grid);
  std::vector<detail::BandBounds> cells;
  for (std::uint32_t i = 0; i < kCells; ++i) {
    cells.push_back(detail::band_bounds(tube.surface, double(i) / kCells, double(i + 1) / kCells));
  }
  const auto bands =
      detail::loft_bands(std::move(cells), detail::allowed_error(options.tolerance, displacement),
                         largest_radius(tube.surface), sampling.segments);
  std::vector<detail::LoftRow> rows;
  for (const double t : bands.knots) {
    rows.push_back(row_at(tube.surface, t));
  }
  return {detail::lofted(tube.start, tube.end, rows, sampling), std::uint32_t(rows.size() - 1),
          bands.error_bound + displacement, bands.knots};
}

}  // namespace dupin
