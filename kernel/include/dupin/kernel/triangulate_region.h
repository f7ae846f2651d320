#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// The region of the plane that closed polygons bound: what lies within an odd number of them. They
/// are told by the indices of their corners, may run either way round and have corners in common.
///
/// Its constrained triangulation, counter-clockwise, by exact predicates, flipped towards Delaunay
/// as far as doubles can tell: corners are those of the polygons and the `inner` points within the
/// region, and no others; every side of a polygon is a side of a triangle. The same input gives the
/// same triangles, none for no polygons. O(n log n) expected.
///
/// Throws Error{self_intersecting} where they cross, or touch in other places than common corners,
/// or an inner point lies on them, and Error{invalid_argument} for fewer than three corners, for
/// numbers that are not finite and for indices of no point.
[[nodiscard]] std::vector<Triangle> triangulate_region(
    std::span<const Vec2> points, std::span<const std::vector<std::uint32_t>> polygons,
    std::span<const std::uint32_t> inner = {});

/// The same for inner points of which more are added later: up to what doubles can tell the
/// triangles that all would have at once. To add one costs the way to it from the last one, and
/// what it changes.
class RegionTriangulation {
 public:
  RegionTriangulation(std::span<const Vec2> points,
                      std::span<const std::vector<std::uint32_t>> polygons,
                      std::span<const std::uint32_t> inner = {});
  ~RegionTriangulation();

  /// Inner points, whose indices follow those of all before. Throws as `triangulate_region`.
  void add(std::span<const Vec2> points);
  [[nodiscard]] std::vector<Triangle> triangles() const;

 private:
  class Region;
  std::unique_ptr<Region> region_;
};

}  // namespace dupin
