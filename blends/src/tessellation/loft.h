#pragma once

#include <cstdint>
#include <vector>

#include "dupin/blends/tessellate.h"
#include "ringed/second_derivatives.h"

namespace dupin::tessellation {

/// A row of mesh points: center + cos u a + sin u b, with a and b orthogonal.
struct LoftRow {
  Vec3 center, a, b;
};

/// Where rows lie along a tube, and how far the mesh between them is from it.
struct LoftBands {
  std::vector<double> knots;
  double error_bound = 0;
};

/// As few bands as keep to `allowed`, from bounds of the second derivatives on equal cells of [0,
/// 1], for rows whose parameter u is turned by at most half a segment over the whole tube.
[[nodiscard]] LoftBands loft_bands(std::vector<ringed::BandBounds> cells, double allowed,
                                   double largest_radius, std::uint32_t segments);

/// The mesh between the polygons of two stored rings and the rows between them. The first and last
/// row say where on the surface the rings' polygons begin; their points are the polygons'.
[[nodiscard]] TriMesh lofted(const Ring& start, const Ring& end, const std::vector<LoftRow>& rows,
                             const RingSampling& sampling);

}  // namespace dupin::tessellation
