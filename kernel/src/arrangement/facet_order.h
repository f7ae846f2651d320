#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/input.h"

namespace dupin::arrangement {

/// A triangle that ends at an edge, as a half-plane around it.
struct HalfPlane {
  PointId apex;           ///< its corner off the edge
  std::uint32_t support;  ///< a triangle of the input with its plane and orientation
  bool forward;           ///< it runs along the edge from its lower to its upper end
  std::uint32_t owner;    ///< for the caller
};

/// Sorts half-planes around their common edge, counter-clockwise about its direction from the lower
/// to the upper end, beginning with the first. No two of them overlap. Needs UpwardRounding.
void order_facets_around_edge(const ArrangementInput& input, std::vector<HalfPlane>& half_planes);

}  // namespace dupin::arrangement
