#pragma once

#include <optional>
#include <string>

#include "dupin/kernel/mesh.h"

namespace dupin::cli {

/// A plane across an axis of coordinates, and the label of what closes a mesh there.
struct PlaneCut {
  double place = 0;
  std::string name;
};

/// What of a closed mesh lies between two planes across an axis, 0 to 2, closed again by triangles
/// in these planes, which have the planes' names. What is on the other side of a plane, cut
/// likewise, has the same points and triangles there, turned: points depend on the mesh's edges and
/// the plane only. O(n), and O(m log m) for m triangles in planes.
///
/// Throws Error{invalid_argument} where a point of the mesh is in a plane, where the mesh is not
/// closed, or where what lies in a plane is bounded by polygons that, in doubles, cross or touch.
[[nodiscard]] TriMesh between_planes(const TriMesh& mesh, int axis,
                                     const std::optional<PlaneCut>& from,
                                     const std::optional<PlaneCut>& to);

}  // namespace dupin::cli
