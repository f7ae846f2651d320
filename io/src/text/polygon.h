#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::text {

/// Cutting more corners could take minutes.
inline constexpr std::size_t kLargestPolygon = 20000;

/// Throws Error{limit_exceeded} for a face of more.
[[noreturn]] void refuse_polygon(std::size_t corners, std::string where);

/// Cuts the polygon with these corners into size - 2 triangles of the same orientation and appends
/// them. Ears are clipped in the coordinate plane that the polygon is least inclined to, by exact
/// predicates: right for every simple planar polygon. A polygon that is not simple there gets the
/// same number of triangles with the same boundary. O(n) for convex polygons; for r reflex corners
/// typically O(n r).
///
/// Requires at least three corners, all of them indices into `points`, and no more than
/// kLargestPolygon.
void cut_into_triangles(std::span<const std::uint32_t> corners, const std::vector<Vec3>& points,
                        std::vector<Triangle>& triangles);

/// The same; a polygon that is a triangle is just appended, and one that is too large is refused,
/// as that at where().
template <class Where>
void triangulate(std::span<const std::uint32_t> corners, const std::vector<Vec3>& points,
                 std::vector<Triangle>& triangles, const Where& where) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
  } else if (corners.size() > kLargestPolygon) {
    refuse_polygon(corners.size(), where());
  } else {
    cut_into_triangles(corners, points, triangles);
  }
}

}  // namespace dupin::text
