#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"

namespace dupin::detail {

/// A triangle that ends at an edge, as a half-plane around it.
struct Sheet {
  PointId apex;           ///< its corner off the edge
  std::uint32_t support;  ///< a triangle of the scene with its plane and orientation
  bool forward;           ///< it runs along the edge from its lower to its upper end
  std::uint32_t owner;    ///< for the caller
};

/// Sorts sheets around their common edge, counter-clockwise about its direction from the lower to
/// the upper end, beginning with the first. No two of them overlap. Needs UpwardRounding.
void sort_around_edge(const Scene& scene, std::vector<Sheet>& sheets);

}  // namespace dupin::detail
