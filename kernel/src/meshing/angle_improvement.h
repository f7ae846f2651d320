#pragma once

#include <array>

#include "mesh/surface_distance.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// The smallest angle of a triangle, in radians; 0 if it is degenerate.
[[nodiscard]] double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// What moves of points keep to, where it was kept before.
struct MoveLimits {
  double longest_edge = 0;
  double distance = 0;  ///< of triangles from the surface
};

/// Moves points along their regions until triangles have no angle below `wanted`, in radians, or
/// nothing is gained any more. A move never makes the smallest angle about its point smaller, nor
/// a triangle turn by a right angle, nor a tetrahedron turn or vanish, by exact predicates, and
/// goes not further than to a neighbour; edges get no longer than they are, or than the longest
/// allowed.
void improve_angles(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, double wanted,
                    const MoveLimits& limits);

/// The smallest angle between two faces of a positive tetrahedron, in radians.
[[nodiscard]] double smallest_dihedral_angle(const std::array<Vec3, 4>& corners);

/// Moves points, those inside anywhere and others along their regions, until tetrahedra have no
/// dihedral angle below `wanted`, in radians, or nothing is gained any more: slivers that Delaunay
/// refinement leaves. Triangles keep their angles, or `wanted_of_triangles`.
void improve_dihedral_angles(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, double wanted,
                             double wanted_of_triangles, const MoveLimits& limits);

}  // namespace dupin::meshing
