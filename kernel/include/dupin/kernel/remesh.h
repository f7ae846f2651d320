#pragma once

#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"

namespace dupin {

struct Remeshed {
  Solid solid;  ///< labelled as the one given
  RemeshReport report;
};

/// A mesh of well-shaped triangles for the same solid: what generators of volume meshes take.
/// Points are new, but for the ends of sharp edges and of borders between labels; these are kept as
/// curves that edges run along. Each region between curves has a mesh of its own: triangles of a
/// Delaunay triangulation that is refined until they are small, near and well-shaped enough (CGAL's
/// Mesh_3); where angles beside sharp edges are poor, points are then moved along the surface,
/// edges turned, and points drawn into their neighbours. How far the sides of a wall are apart does
/// not matter. Distances are proved at the end, both ways, and that the surface does not meet
/// itself is proved anew, as by `Solid::from`; where either fails, less is asked for of the regions
/// at fault. The same input gives the same mesh, whatever the number of threads: some 14 000
/// triangles a second on each. Throws Error{invalid_argument} for options outside their range,
/// Error{contact} for a solid that touches itself, Error{limit_exceeded} where lengths and
/// distances ask for too many points, Error{unroundable} as `to_mesh`, or, never giving a worse
/// mesh, where the distance cannot be kept, and Error{cancelled}.
[[nodiscard]] Remeshed remesh(const Solid& solid, const RemeshOptions& options);

}  // namespace dupin
