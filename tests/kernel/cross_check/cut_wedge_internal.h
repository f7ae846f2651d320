#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/boolean.h"
#include "mesh/exact_mesh.h"
#include "support/shapes.h"

/// A body with points that no doubles hold, and its exact measures.
namespace dupin::test {

/// The tetrahedron below the plane x + y / 3 + z = 1.
inline TriMesh wedge(const Vec3& at) {
  TriMesh mesh = tetrahedron();
  mesh.points[2].y() = 3;
  return moved(mesh, at);
}

/// A box with the part of the wedge up to y = 1. What is cut off is a similar wedge of 2/3 the
/// size; two new corners are (2/3, 1, 0) and (0, 1, 2/3).
inline TriMesh slab(const Vec3& at) { return moved(box(Vec3(-1, -1, -5), Vec3(2, 1, 2)), at); }

inline const mpq_class kCutWedgeVolume = mpq_class(1, 2) * (1 - mpq_class(8, 27));

/// By our own engine.
inline Solid cut_wedge(const Vec3& at) {
  return intersect(std::vector{Solid::from(wedge(at)), Solid::from(slab(at))});
}

/// The exact coordinates of points, which the engines may order as they like.
inline std::vector<std::array<mpq_class, 3>> sorted_points(const Solid& solid) {
  std::vector<std::array<mpq_class, 3>> points;
  for (std::uint32_t i = 0; i < solid.point_count(); ++i) {
    points.push_back(solid.exact_point(i));
  }
  std::ranges::sort(points);
  return points;
}

}  // namespace dupin::test
