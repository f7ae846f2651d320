#pragma once

#include "meshing/surface_distance.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// The smallest angle of a triangle, in radians; 0 if it is degenerate.
[[nodiscard]] double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Moves points along their regions until triangles have no angle below `wanted`, in radians, or
/// nothing is gained any more. A move never makes the smallest angle about its point smaller, nor
/// a tetrahedron turn or vanish, by exact predicates, and goes not further than to a neighbour.
void improve_angles(Tetrahedra& mesh, const ReferenceSurface& surface, double wanted);

}  // namespace dupin::meshing
