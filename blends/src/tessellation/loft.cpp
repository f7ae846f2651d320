#include "tessellation/loft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tessellation/band_stepper.h"

namespace dupin::tessellation {
namespace {

// The parameter u of the polygon's first point in the row that runs through it.
double first_parameter(const Ring& ring, const LoftRow& row, const RingSampling& sampling) {
  const Vec3 to_point = sample(ring, {sampling.segments, sampling.phase, 0}).front() - row.center;
  return std::atan2(to_point.dot(row.b) / row.b.squaredNorm(),
                    to_point.dot(row.a) / row.a.squaredNorm());
}

}  // namespace

LoftBands loft_bands(std::vector<ringed::BandBounds> cells, double allowed, double largest_radius,
                     std::uint32_t segments) {
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  const double around = 2 * std::numbers::pi / segments;
  const BandStepper march(std::move(cells), around);
  const BandBudget budget = band_budget(allowed, largest_radius, around);
  const double twist = around / 2 / double(march.knots(budget.enough, 0, kNoLimit).size() - 1);
  LoftBands result{even_knots(march, budget, twist), 0};
  result.error_bound = march.error_bound(result.knots, twist);
  return result;
}

TriMesh lofted(const Ring& start, const Ring& end, const std::vector<LoftRow>& rows,
               const RingSampling& sampling) {
  const std::uint32_t n = sampling.segments;
  const double segment = 2 * std::numbers::pi / n;
  const double first = first_parameter(flipped(start), rows.front(), sampling);
  const double angle = first_parameter(end, rows.back(), sampling) - first;
  const auto whole = std::lround(angle / segment);
  const double twist = angle - double(whole) * segment;
  const auto count = long(n), shift = ((-whole) % count + count) % count;

  TriMesh mesh = first_row(sample(flipped(start), sampling), rows.size() - 1);
  for (std::size_t j = 1; j + 1 < rows.size(); ++j) {
    const auto& [center, a, b] = rows[j];
    const double turned = first + twist * double(j) / double(rows.size() - 1);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double u = turned + segment * i;
      mesh.points.push_back(snapped(center + std::cos(u) * a + std::sin(u) * b, sampling.grid));
    }
    append_band(mesh, n);
  }
  auto last = sample(end, sampling);
  std::rotate(last.begin(), last.begin() + shift, last.end());
  mesh.points.insert(mesh.points.end(), last.begin(), last.end());
  append_band(mesh, n);
  return mesh;
}

}  // namespace dupin::tessellation
