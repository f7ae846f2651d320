#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/vec.h"

namespace dupin::tessellation {

/// How large the triangles of a region may be, and how they are filled in.
struct Refinement {
  double spacing = 0.8;  ///< of the lattice of points that the region is first filled with
  double widest = 1;     ///< that a triangle may be in x
};

/// The polygons' corners first, then the new points.
struct RefinedRegion {
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;
};

/// The region that closed polygons bound (as `triangulate_region`), with points inside of it so
/// that its triangles are no slivers; sides of polygons are not divided.
///
/// A lattice where it is that far from the sides, then the centres of the circles about triangles
/// that are too wide or have an angle below 25 degrees (L. P. Chew, 1989; J. Ruppert, 1995), unless
/// such a centre sees a side under more than 120 degrees. So what is left of small angles is at
/// sides: next to one that is much longer than its distance from another, or between sides. The
/// same input gives the same points. Expected O(n log n) of the points that it makes.
///
/// Throws as `triangulate_region`.
[[nodiscard]] RefinedRegion refined_region(std::vector<Vec2> points,
                                           const std::vector<std::vector<std::uint32_t>>& polygons,
                                           const Refinement& refinement = {});

}  // namespace dupin::tessellation
